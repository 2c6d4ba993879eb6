// Dithers what is stored in 8-bit targets, with the student's function. Given.
#include "02-blinn-phong/blinn_phong.glsl"
#include "08-post-processing/post_processing.glsl"

// Interleaved gradient noise (Jimenez, "Next Generation Post Processing in Call of Duty: Advanced Warfare", SIGGRAPH
// 2014): even over 0..1 in each neighbourhood.
float noise_at(vec2 pixel) { return fract(52.9829189 * fract(dot(floor(pixel), vec2(0.06711056, 0.00583715)))); }

// A colour as it is stored: 8-bit targets hold sRGB codes, and that is what is dithered. DITHER is the number of the
// pass, since each needs noise of its own: what one pass has rounded up, the next would round up again.
vec4 kept(vec4 colour) {
#if defined(DITHER) && defined(STORED_IN_8_BITS)
  vec3 code = dithered(srgb_encode(clamp(colour.rgb, 0.0, 1.0)), noise_at(gl_FragCoord.xy + 37.0 * float(DITHER)));
  colour.rgb = srgb_decode(clamp(code, 0.0, 1.0));
#endif
  return colour;
}
