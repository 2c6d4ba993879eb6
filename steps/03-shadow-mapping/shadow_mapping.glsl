// 03-shadow-mapping, the lookup: how much of a light reaches a point. What each function must do stands in
// shadow_mapping.hpp; the structs and uniforms are these:
#include "03-shadow-mapping/given/shadows.glsl"

// ---- One lookup

vec3 shadow_coordinate(mat4 world_to_map, vec3 position) {
  // TODO(03-shadow-mapping): multiply, divide by w; behind the light there is no such point
  return vec3(0.0, 0.0, 2.0);
}

float map_width(ShadowLight light, float depth) {
  // TODO(03-shadow-mapping): a pyramid grows with the depth, a box does not
  return 1.0;
}

float compare_depth(vec3 coordinate, int layer) {
  // TODO(03-shadow-mapping): compare z with the depth that is stored at (u, v), by COMPARE
  return 1.0;
}

// ---- Bias: the point is moved before it is looked up

vec3 constant_bias(vec3 position, vec3 to_light, float amount) {
  // TODO(03-shadow-mapping): towards the light
  return position;
}

vec3 slope_bias(vec3 position, vec3 normal, vec3 to_light, vec3 axis, float amount) {
  // TODO(03-shadow-mapping): towards the light, the more the flatter the surface lies to it
  return position;
}

vec3 normal_offset(vec3 position, vec3 normal, vec3 axis, float amount) {
  // TODO(03-shadow-mapping): off the surface, the more the steeper it stands in the map
  return position;
}

vec2 plane_slope(vec3 dx, vec3 dy) {
  // TODO(03-shadow-mapping): two equations, s.x du + s.y dv = dz, by Cramer's rule; parallel directions have no answer
  return vec2(0.0);
}

// ---- Many lookups

float pcf(vec3 coordinate, vec2 slope, int layer) {
  // TODO(03-shadow-mapping): the mean over a square of PCF x PCF texels; a texel is 1 / textureSize of the map wide
  return compare_depth(coordinate, layer);
}

// ---- Soft shadows

float linear_depth(ShadowLight light, float z) {
  // TODO(03-shadow-mapping): undo the projection
  return z;
}

float penumbra_width(ShadowLight light, float receiver, float blocker) {
  // TODO(03-shadow-mapping): similar triangles: the light, the blocker's edge, the receiver
  return 0.0;
}

#ifdef PCSS
float blocker_depth(ShadowLight light, vec3 coordinate, vec2 slope, float search) {
  // TODO(03-shadow-mapping): the mean linear depth of the samples that stand nearer to the light than the surface
  return -1.0;
}

float pcss(ShadowLight light, vec3 coordinate, vec2 slope, float receiver) {
  // TODO(03-shadow-mapping): search for blockers, estimate the penumbra, filter as wide as it is
  return compare_depth(coordinate, light.layer);
}
#endif

// ---- All together

float shadow_factor(ShadowLight light, vec3 position, vec3 normal, vec3 to_light) {
  // TODO(03-shadow-mapping): bias by BIAS, coordinate, slope, then pcf or pcss
  return 1.0;
}
