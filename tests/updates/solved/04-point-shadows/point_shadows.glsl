// 04-point-shadows, the lookup: how much of a lamp's light reaches a point. What each function must do stands in
// point_shadows.hpp; the structs, uniforms and cubes are these:
#include "04-point-shadows/cubes.glsl"
// Step 03's functions, among them the biases:
#include "03-shadow-mapping/shadow_mapping.glsl"

float cube_texel(vec3 from_light, float resolution) {
  vec3 along = abs(from_light);
  return 2.0 * max(along.x, max(along.y, along.z)) / resolution;
}

float cube_lit(int cube, vec3 from_light, float reference) {
  if (dot(from_light, from_light) == 0.0) return 1.0;
#ifdef COMPARE
  return compared_with_cube(cube, from_light, reference);
#else
  return reference <= stored_in_cube(cube, from_light) ? 1.0 : 0.0;
#endif
}

float cube_pcf(CubeLight light, vec3 from_light, float reference) {
  if (dot(from_light, from_light) == 0.0) return 1.0;
  vec3 along = abs(from_light);
  vec3 axis = along.x <= along.y && along.x <= along.z ? vec3(1.0, 0.0, 0.0)
              : along.y <= along.z                      ? vec3(0.0, 1.0, 0.0)
                                                        : vec3(0.0, 0.0, 1.0);
  vec3 u = normalize(cross(axis, from_light)), v = cross(normalize(from_light), u);
  float texel = cube_texel(from_light, cube_resolution());
  float sum = 0.0;
  for (int y = 0; y < PCF; ++y)
    for (int x = 0; x < PCF; ++x) {
      vec2 offset = texel * (vec2(x, y) - 0.5 * float(PCF - 1));
      sum += cube_lit(light.cube, from_light + offset.x * u + offset.y * v, reference);
    }
  return sum / float(PCF * PCF);
}

float point_shadow_factor(CubeLight light, vec3 position, vec3 normal, vec3 to_light) {
  float amount = u_bias * KERNEL * cube_texel(position - light.position, cube_resolution());
#if BIAS == 1
  position = constant_bias(position, to_light, amount);
#elif BIAS == 2
  position = slope_bias(position, normal, to_light, to_light, amount);
#elif BIAS >= 3
  position = normal_offset(position, normal, to_light, amount);
#endif
  vec3 from_light = position - light.position;
  float reference = min(length(from_light) / light.far, 1.0);
#if BIAS != 0
  reference -= u_depth_step;
#endif
  return cube_pcf(light, from_light, reference);
}
