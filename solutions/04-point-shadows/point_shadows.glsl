// 04-point-shadows, the lookup: which fraction of a point light reaches a point. The contract of a function is the
// comment above it. World space, metres. A cube stores distances from the light as fractions of light.far. from_light
// is the vector from the light to a point, in metres.
//
// Given, in the first file included below:
//   CubeLight    vec3 position; float far; int cube, the number of its cube map
//   float cube_resolution()        texels along an edge of a cube map; 1 where the scene has none
//   float stored_in_cube(int cube, vec3 direction)                          only where COMPARE is not defined
//   float compared_with_cube(int cube, vec3 direction, float reference)     only where COMPARE is defined
//   PCF, BIAS, FILTER_WIDTH, u_bias, u_depth_epsilon                        as in step 03
// CUBES is the number of cube maps, 0 to 4. Their samplers u_cube_0, u_cube_1 ... are declared only as far as there are
// any, so read them through these functions alone.
#include "04-point-shadows/given/cubes.glsl"
// Step 03's functions, the biases among them:
#include "03-shadow-mapping/shadow_mapping.glsl"

// The width of a texel of the cube at this point, in metres, for `resolution` texels along an edge. It is measured in
// the plane through the point that is parallel to the face. A zero vector: 0. from_light = (3, -1, 2), 512 texels:
// 0.01172 m. Handout, section 5.
float cube_texel(vec3 from_light, float resolution) {
  // >>> student: the width of a face at this distance, divided by its texels
  vec3 along = abs(from_light);
  return 2.0 * max(along.x, max(along.y, along.z)) / resolution;
  // --- skeleton
  // | return 0.0;
  // <<< student
}

// 1 where the reference (a distance as a fraction of far) is at most what the cube stores in this direction, otherwise
// 0. 1 for a zero vector. The length of from_light does not matter. stored_in_cube(cube, direction) returns the stored
// value. With COMPARE (further), compared_with_cube(cube, direction, reference) returns the answers of four texels,
// interpolated. Handout, section 4.
float compare_cube_distance(int cube, vec3 from_light, float reference) {
  // >>> student: compare the reference with what is stored in this direction, with and without COMPARE
  if (dot(from_light, from_light) == 0.0) return 1.0;
#ifdef COMPARE
  return compared_with_cube(cube, from_light, reference);
#else
  return reference <= stored_in_cube(cube, from_light) ? 1.0 : 0.0;
#endif
  // --- skeleton
  // | return 1.0;
  // <<< student
}

// The mean of PCF x PCF comparisons, all with this reference, in a square grid of directions around from_light. The
// steps of the grid are one texel long (cube_texel), along the unit vectors u = normalize(cross(a, from_light)) and v =
// cross(normalize(from_light), u); the centre of the grid is from_light. a is the axis (x, y or z) along which
// from_light has the smallest absolute component, the first one if two are equal. 1 for a zero vector.
// Handout, section 6. You may call: cube_texel, cube_resolution, compare_cube_distance.
float cube_pcf(CubeLight light, vec3 from_light, float reference) {
  // >>> student: two directions perpendicular to from_light, and a grid of comparisons along them
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
      sum += compare_cube_distance(light.cube, from_light + offset.x * u + offset.y * v, reference);
    }
  return sum / float(PCF * PCF);
  // --- skeleton
  // | return compare_cube_distance(light.cube, from_light, reference);
  // <<< student
}

// The fraction of the light that reaches a point, 0 to 1. `normal` is of unit length or zero.
// - BIAS chooses how the point is moved before it is looked up, with step 03's functions: 1 constant_bias, 2
//   slope_bias, 3 and 4 normal_offset; with 0 it is not moved. The axis is to_light, because distances are stored and
//   not depths. The amount is u_bias * FILTER_WIDTH texels, a texel as wide as it is at the point before it is moved.
// - Direction and distance are those of the moved point. The distance, as a fraction of light.far, is at most 1: a
//   point beyond far is compared as if it were at far. With BIAS other than 0 it is then lowered by u_depth_epsilon.
// Handout, sections 4 to 6. You may call: cube_texel, cube_resolution, cube_pcf, step 03's three biases.
float point_shadow_factor(CubeLight light, vec3 position, vec3 normal, vec3 to_light) {
  // >>> student: bias, then direction and distance of the moved point
  float amount = u_bias * FILTER_WIDTH * cube_texel(position - light.position, cube_resolution());
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
  reference -= u_depth_epsilon;
#endif
  return cube_pcf(light, from_light, reference);
  // --- skeleton
  // | return 1.0;
  // <<< student
}
