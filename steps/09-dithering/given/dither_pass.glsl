// What the passes of this step do to a pixel, with the student's functions. Given.
#include "02-blinn-phong/blinn_phong.glsl"
#include "08-post-processing/post_processing.glsl"
#include "09-dithering/dithering.glsl"

uniform float u_levels;
uniform sampler2D u_ranks;  // whole numbers; row 0 is row 0 of the pattern
uniform int u_side;         // of the pattern, cells
uniform mat3 u_view_to_world;
uniform float u_half_height;  // of the picture at a distance of 1
uniform vec3 u_eye_of_view;

vec3 grey_of(vec3 colour) { return vec3(luma(colour)); }
vec4 grey_pass(vec2 texcoord) {
  vec4 c = texture(u_picture, texcoord);
  return vec4(grey_of(c.rgb), c.a);
}

// ---- The cell of the pattern

uniform float u_cell;  // pixels

// The angle that a cell covers in the middle of the picture, radians.
float cell_angle() { return u_cell * 2.0 * u_half_height / u_size.y; }

// Counted from the upper left corner.
vec2 cell_on_screen() { return vec2(floor(gl_FragCoord.x), u_size.y - 1.0 - floor(gl_FragCoord.y)); }

// All faces have as many cells, and the same ones.
vec2 cell_on_sphere(vec2 texcoord) {
  vec2 ndc = 2.0 * texcoord - 1.0;
  vec3 direction = u_view_to_world * vec3(ndc * u_half_height * vec2(u_size.x / u_size.y, 1.0), -1.0);
  float cells = round(1.57079632679 / cell_angle());
  return floor((0.5 * cube_place(direction).xy + 0.5) * cells);
}

#ifdef PATTERN
float threshold_in(vec2 cell) {
  float side = float(u_side);
  ivec2 texel = ivec2(cell - side * floor(cell / side));
  return threshold_of(texelFetch(u_ranks, texel, 0).r, side * side);
}
#endif

#ifdef HELD_BY_WORLD
// 0 where there is no surface.
vec3 normal_at(vec2 texcoord) {
  vec3 code = texture(u_normal, texcoord).rgb;
  return code == vec3(0.0) ? vec3(0.0) : 2.0 * code - 1.0;
}

float threshold_in_world(vec2 texcoord) {
  vec3 position = texture(u_position, texcoord).rgb, normal = normal_at(texcoord);
  if (normal == vec3(0.0)) return threshold_in(cell_on_sphere(texcoord));
  vec2 octave = octave_of(length(position - u_eye_of_view) * cell_angle());
  vec2 place = surface_place(position, normal) / exp2(octave.x);
  // The cells of twice the size start elsewhere in the pattern: both thresholds shall be independent.
  return mixed_threshold(threshold_in(floor(place)), threshold_in(floor(0.5 * place) + vec2(23.0, 41.0)), octave.y);
}
#endif

float threshold_here(vec2 texcoord) {
#if !defined(PATTERN)
  return 0.5;
#elif defined(HELD_BY_WORLD)
  return threshold_in_world(texcoord);
#elif defined(HELD_BY_SPHERE)
  return threshold_in(cell_on_sphere(texcoord));
#else
  return threshold_in(cell_on_screen());
#endif
}

vec4 dither_pass(vec2 texcoord) {
  vec4 c = texture(u_picture, texcoord);
  vec3 colour = c.rgb;
#ifdef GREY
  colour = grey_of(colour);
#endif
  colour = clamp(colour, 0.0, 1.0);
#ifndef LINEAR
  colour = srgb_encode(colour);
#endif
  float threshold = threshold_here(texcoord);
  for (int i = 0; i < 3; ++i) colour[i] = level_of(colour[i], threshold, u_levels) / (u_levels - 1.0);
#ifndef LINEAR
  colour = srgb_decode(clamp(colour, 0.0, 1.0));
#endif
  return vec4(colour, c.a);
}

// ---- Lines

#ifdef LINES
// Whether a line is drawn between this pixel and another. Where nothing is seen, normals and positions are 0.
bool line_between(vec2 texcoord, vec2 other) {
  vec3 here_code = texture(u_normal, texcoord).rgb, there_code = texture(u_normal, other).rgb;
  bool here = here_code != vec3(0.0), there = there_code != vec3(0.0);
  if (!here || !there) return here != there;
  vec3 a = texture(u_position, texcoord).rgb, b = texture(u_position, other).rgb;
  float distance = min(length(a - u_eye_of_view), length(b - u_eye_of_view));
  return edge_between(a, normalize(2.0 * here_code - 1.0), b, normalize(2.0 * there_code - 1.0), distance);
}

vec4 line_pass(vec2 texcoord) {
  vec4 c = texture(u_picture, texcoord);
  vec2 right = texcoord + vec2(1.0 / u_size.x, 0.0), above = texcoord + vec2(0.0, 1.0 / u_size.y);
  bool line = (right.x < 1.0 && line_between(texcoord, right)) || (above.y < 1.0 && line_between(texcoord, above));
  return line ? vec4(vec3(LINES), c.a) : c;
}
#endif
