// Types, uniforms and macros of step 03's shaders. Given. World space, metres.
#include "02-blinn-phong/given/lights.glsl"

struct ShadowLight {
  mat4 world_to_map;  // bias_matrix() * light_projection() * light_view()
  vec3 eye;           // depth is measured from here
  vec3 direction;     // unit vector: the light's view direction; depth is measured along it
  float half_width;   // spot: tangent of half the angle of view; directional: half the width of its box, metres
  float near, far;    // depths of the two planes, metres
  float width;        // of the light source. Spot: side of a square, metres; directional: tangent of its angle
  bool directional;   // otherwise a spot light
  int layer;          // of u_shadow_maps
};

// All lights that have a map.
#if SHADOW_LIGHTS > 0
uniform ShadowLight u_shadow_lights[SHADOW_LIGHTS];
#endif

#ifdef COMPARE
uniform sampler2DArrayShadow u_shadow_maps;  // texture(u_shadow_maps, vec4(u, v, layer, depth)) compares
#else
uniform sampler2DArray u_shadow_maps;  // texture(u_shadow_maps, vec3(u, v, layer)).r is the stored depth
#endif

uniform float u_bias;           // the bias in texels, for one comparison with one texel
uniform float u_depth_epsilon;  // depth-comparison epsilon: equal depths may differ by this much after rounding, 0..1

// The program defines: PCF (comparisons along a side of the filter), BIAS (0 to 4), COMPARE (comparisons are bilinear),
// PCSS and SAMPLES (soft shadows).
//
// COMPARISON_HALF_WIDTH: one comparison depends on a square of texels. This is half its side, in texels: a nearest
// comparison depends on one texel, a bilinear one on texels up to one texel away.
// FILTER_WIDTH: the side of the square of texels on which all PCF x PCF comparisons together depend, in texels.
#ifdef COMPARE
#define FILTER_WIDTH float(PCF + 1)
#define COMPARISON_HALF_WIDTH 1.0
#else
#define FILTER_WIDTH float(PCF)
#define COMPARISON_HALF_WIDTH 0.5
#endif

#ifdef PCSS
// Sample i of SAMPLES, in the square from -1/2 to 1/2: the centre of a cell of a grid, or a random point, different in
// each pixel (PCG after Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020).
vec2 sample_point(int i) {
#ifdef RANDOM
  uvec3 v = uvec3(uvec2(gl_FragCoord.xy), uint(i)) * 1664525u + 1013904223u;
  v.x += v.y * v.z, v.y += v.z * v.x, v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z, v.y += v.z * v.x;
  return vec2(v.xy >> 8u) / 16777216.0 - 0.5;
#else
  int side = int(sqrt(float(SAMPLES)) + 0.5);
  return (vec2(i % side, i / side) + 0.5) / float(side) - 0.5;
#endif
}
#endif
