// What each pass of the chain does to a pixel, with the student's functions. Given.
#include "02-blinn-phong/blinn_phong.glsl"
#include "08-post-processing/post_processing.glsl"
#include "08-post-processing/given/noise.glsl"

uniform float u_threshold, u_bloom, u_stops, u_white, u_turns, u_saturation, u_brightness, u_overlay_amount;
uniform vec3 u_table_low, u_table_high;
uniform sampler3D u_table;
uniform sampler2D u_overlay;

vec4 here(vec2 texcoord) { return texture(u_picture, texcoord); }

// ---- What a pass does, on a value

vec4 tone_of(vec4 c, vec2 texcoord) { return vec4(tone_mapped(c.rgb, u_stops, CURVE, u_white), c.a); }

vec4 adjust_of(vec4 c, vec2 texcoord) { return vec4(adjusted(c.rgb, u_turns, u_saturation, u_brightness), c.a); }

// Tables are for sRGB-encoded colours.
vec4 table_of(vec4 c, vec2 texcoord) {
  vec3 encoded = srgb_encode(clamp(c.rgb, 0.0, 1.0));
  vec3 place = clamp((encoded - u_table_low) / (u_table_high - u_table_low), 0.0, 1.0);
#ifdef TETRAHEDRAL
  vec3 found = table_tetrahedral(u_table, place);
#else
  vec3 found = table_trilinear(u_table, place);
#endif
  return vec4(srgb_decode(found), c.a);
}

vec4 overlay_of(vec4 c, vec2 texcoord) { return overlaid(c, texture(u_overlay, texcoord), u_overlay_amount); }

// ---- The passes

vec4 tone_pass(vec2 texcoord) { return kept(tone_of(here(texcoord), texcoord)); }
vec4 adjust_pass(vec2 texcoord) { return kept(adjust_of(here(texcoord), texcoord)); }
vec4 table_pass(vec2 texcoord) { return kept(table_of(here(texcoord), texcoord)); }
vec4 overlay_pass(vec2 texcoord) { return kept(overlay_of(here(texcoord), texcoord)); }

#ifdef FUSED
// Several of them without storing what is between them.
vec4 fused_pass(vec2 texcoord) {
  vec4 c = here(texcoord);
  FUSED
  return kept(c);
}
#endif

vec4 bright_pass(vec2 texcoord) { return kept(vec4(bright_part(here(texcoord).rgb, u_threshold), 1.0)); }
vec4 blur_x_pass(vec2 texcoord) { return kept(vec4(blurred(u_picture, texcoord, vec2(1.0 / u_size.x, 0.0)), 1.0)); }
vec4 blur_y_pass(vec2 texcoord) { return kept(vec4(blurred(u_picture, texcoord, vec2(0.0, 1.0 / u_size.y)), 1.0)); }
#ifdef BLOOM
vec4 bloom_pass(vec2 texcoord) {
  vec4 scene = texture(u_colour, texcoord);
  return kept(vec4(scene.rgb + u_bloom * here(texcoord).rgb, scene.a));
}
#endif

#ifdef FETCHES
// The mean of several texels, which all are this pixel's: u_nowhere is 0, which the compiler does not know.
uniform vec2 u_nowhere;
vec4 fetching_pass(vec2 texcoord) {
  vec4 sum = vec4(0.0);
  for (int i = 0; i < FETCHES; ++i) sum += texture(u_picture, texcoord + float(i) * u_nowhere);
  return sum / float(FETCHES);
}
#endif
