// What step 03's shaders know about lights that cast shadows. Given. World space, metres.
#include "02-blinn-phong/given/lights.glsl"

struct ShadowLight {
  mat4 world_to_map;  // bias_matrix() * light_projection() * light_view()
  vec3 eye;           // from where depth is measured
  vec3 direction;     // of unit length: the way that the light looks
  float half_width;   // a spot's: tangent of half its angle of view; a sun's: half the width of its box, metres
  float near, far;    // along the direction
  float width;        // of the light itself: a spot is a square of this side; a sun spans an angle with this tangent
  bool sun;           // orthographic
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

uniform float u_bias;        // texels
uniform float u_depth_step;  // of a stored depth 0..1: how far rounding may part what is equal

// How wide the square of texels is that one answer rests upon, and how far from its middle a point may lie within one
// texel's share: nearest comparisons stand for their own texel, bilinear ones reach into the next.
#ifdef COMPARE
#define KERNEL float(PCF + 1)
#define RESIDUAL 1.0
#else
#define KERNEL float(PCF)
#define RESIDUAL 0.5
#endif

#ifdef PCSS
// SAMPLES points of the square from -1/2 to 1/2: the middles of a grid of cells, or random ones, others in each pixel
// (PCG after Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020).
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
