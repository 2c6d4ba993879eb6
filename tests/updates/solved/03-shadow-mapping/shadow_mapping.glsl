// 03-shadow-mapping, the lookup: how much of a light reaches a point. What each function must do stands in
// shadow_mapping.hpp; the structs and uniforms are these:
#include "03-shadow-mapping/shadows.glsl"

// ---- One lookup

vec3 shadow_coordinate(mat4 world_to_map, vec3 position) {
  vec4 mapped = world_to_map * vec4(position, 1.0);
  if (mapped.w <= 0.0) return vec3(0.0, 0.0, 2.0);
  vec3 coordinate = mapped.xyz / mapped.w;
  return vec3(coordinate.xy, min(coordinate.z, 1.0));
}

float map_width(ShadowLight light, float depth) {
  return 2.0 * light.half_width * (light.sun ? 1.0 : depth);
}

float lit(vec3 coordinate, int layer) {
  if (coordinate.z > 1.0) return 1.0;
#ifdef COMPARE
  return texture(u_shadow_maps, vec4(coordinate.xy, layer, coordinate.z));
#else
  return coordinate.z <= texture(u_shadow_maps, vec3(coordinate.xy, layer)).r ? 1.0 : 0.0;
#endif
}

// ---- Bias: the point is moved before it is looked up

vec3 constant_bias(vec3 position, vec3 to_light, float amount) {
  return position + amount * to_light;
}

vec3 slope_bias(vec3 position, vec3 normal, vec3 to_light, vec3 axis, float amount) {
  float sine = length(cross(normal, axis)), cosine = max(dot(normal, to_light), 0.01);
  return position + amount * sine / cosine * to_light;
}

vec3 normal_offset(vec3 position, vec3 normal, vec3 axis, float amount) {
  return position + amount * length(cross(normal, axis)) * normal;
}

vec2 plane_slope(vec3 dx, vec3 dy) {
  float determinant = dx.x * dy.y - dx.y * dy.x;
  if (abs(determinant) <= 1e-6 * length(dx.xy) * length(dy.xy)) return vec2(0.0);
  vec2 slope = vec2(dx.z * dy.y - dx.y * dy.z, dx.x * dy.z - dx.z * dy.x) / determinant;
  return clamp(slope, -100.0, 100.0);
}

// ---- Many lookups

float pcf(vec3 coordinate, vec2 slope, int layer) {
  float texel = 1.0 / float(textureSize(u_shadow_maps, 0).x);
  float sum = 0.0;
  for (int y = 0; y < PCF; ++y)
    for (int x = 0; x < PCF; ++x) {
      vec2 offset = texel * (vec2(x, y) - 0.5 * float(PCF - 1));
      sum += lit(coordinate + vec3(offset, dot(slope, offset)), layer);
    }
  return sum / float(PCF * PCF);
}

// ---- Soft shadows

float linear_depth(ShadowLight light, float z) {
  float n = light.near, f = light.far;
  return light.sun ? mix(n, f, z) : n * f / (f - z * (f - n));
}

float penumbra_width(ShadowLight light, float receiver, float blocker) {
  return (receiver - blocker) * light.width / (light.sun ? 1.0 : blocker);
}

#ifdef PCSS
float blocker_depth(ShadowLight light, vec3 coordinate, vec2 slope, float search) {
  float sum = 0.0, count = 0.0;
  for (int i = 0; i < SAMPLES; ++i) {
    vec2 offset = sample_point(i) * search;
    float stored = texture(u_shadow_maps, vec3(coordinate.xy + offset, light.layer)).r;
    if (stored < coordinate.z + dot(slope, offset)) {
      sum += linear_depth(light, stored);
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : -1.0;
}

float pcss(ShadowLight light, vec3 coordinate, vec2 slope, float receiver) {
  if (coordinate.z > 1.0) return 1.0;
  float at_near = max(receiver - light.near, 0.0) * light.width / (light.sun ? 1.0 : receiver);
  float blocker = blocker_depth(light, coordinate, slope, at_near / map_width(light, light.near));
  if (blocker < 0.0) return 1.0;
  float width = penumbra_width(light, max(receiver, blocker), blocker) / map_width(light, receiver);
  float sum = 0.0;
  for (int i = 0; i < SAMPLES; ++i) {
    vec2 offset = sample_point(i) * width;
    sum += lit(coordinate + vec3(offset, dot(slope, offset)), light.layer);
  }
  return sum / float(SAMPLES);
}
#endif

// ---- All together

float shadow_factor(ShadowLight light, vec3 position, vec3 normal, vec3 to_light) {
  float resolution = float(textureSize(u_shadow_maps, 0).x);
  float depth = dot(position - light.eye, light.direction);
  float amount = u_bias * KERNEL * map_width(light, depth) / resolution;
#if BIAS == 1
  position = constant_bias(position, to_light, amount);
#elif BIAS == 2
  position = slope_bias(position, normal, to_light, -light.direction, amount);
#elif BIAS == 3
  position = normal_offset(position, normal, -light.direction, amount);
#endif
  vec3 coordinate = shadow_coordinate(light.world_to_map, position);
#if BIAS != 0
  coordinate.z -= u_depth_step;
#endif
  vec2 slope = vec2(0.0);
#if BIAS == 4 || defined(PCSS)
  slope = plane_slope(dFdx(coordinate), dFdy(coordinate));
  coordinate.z -= u_bias * RESIDUAL * (abs(slope.x) + abs(slope.y)) / resolution;
#endif
#ifdef PCSS
  return pcss(light, coordinate, slope, depth);
#else
  return pcf(coordinate, slope, light.layer);
#endif
}
