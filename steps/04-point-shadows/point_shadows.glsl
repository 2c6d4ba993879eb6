// 04-point-shadows, the lookup: how much of a lamp's light reaches a point. What each function must do stands in
// point_shadows.hpp; the structs, uniforms and cubes are these:
#include "04-point-shadows/given/cubes.glsl"
// Step 03's functions, among them the biases:
#include "03-shadow-mapping/shadow_mapping.glsl"

float cube_texel(vec3 from_light, float resolution) {
  // TODO(04-point-shadows): the face is as far away as the largest component, and twice as wide as far
  return 0.0;
}

float compare_cube_distance(int cube, vec3 from_light, float reference) {
  // TODO(04-point-shadows): compare the reference with what is stored in that direction, by COMPARE
  return 1.0;
}

float cube_pcf(CubeLight light, vec3 from_light, float reference) {
  // TODO(04-point-shadows): two directions square to from_light, and a grid of comparisons along them, a texel apart
  return compare_cube_distance(light.cube, from_light, reference);
}

float point_shadow_factor(CubeLight light, vec3 position, vec3 normal, vec3 to_light) {
  // TODO(04-point-shadows): bias by BIAS, then the moved point's distance and direction
  return 1.0;
}
