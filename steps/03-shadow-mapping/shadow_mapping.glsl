// 03-shadow-mapping, the lookup: which fraction of a light reaches a point. The contract of a function is the comment
// above it. World space, metres, unless something else is said. "In the map" means (u, v) from 0 to 1 across the map
// and z from
// 0 to 1 in depth. ShadowLight, u_shadow_maps and the other uniforms and macros are in this file:
#include "03-shadow-mapping/given/shadows.glsl"

// ---- One lookup

// (u, v, z): where a point lies in the map. world_to_map takes world space to homogeneous coordinates whose x, y and z
// are u, v and z after the division by w. A point with w <= 0 is not in front of the light and gets (0, 0, 2). z is at
// most 1: a point beyond the far plane is compared as if it were on it. Before the near plane z is negative. Handout,
// section 2.
vec3 shadow_coordinate(mat4 world_to_map, vec3 position) {
  // TODO(03-shadow-mapping): from homogeneous coordinates to (u, v, z)
  return vec3(0.0, 0.0, 2.0);
}

// The width of the square that the map covers at this depth, in metres. `depth` is measured along light.direction from
// light.eye, in metres. A spot light with half_width 0.5: 3 m at a depth of 3 m. A directional light with half_width 4:
// 8 m at every depth. Handout, section 4 (the width of the map is that of all its texels).
float map_width(ShadowLight light, float depth) {
  // TODO(03-shadow-mapping): a spot light sees a pyramid, a directional light a box
  return 1.0;
}

// 1 where the coordinate's depth z is at most the depth that is stored at (u, v) in this layer, otherwise 0. 1 where z
//   > 1.
// Outside of the map the texture itself answers with its border, depth 1. With COMPARE (bilinear), u_shadow_maps
// compares: it takes (u, v, layer, z) and returns the four nearest texels' answers, interpolated. Handout, sections 1
// and 7.
float compare_depth(vec3 coordinate, int layer) {
  // TODO(03-shadow-mapping): compare z with the depth that is stored at (u, v), with and without COMPARE
  return 1.0;
}

// ---- Bias: the point is moved before it is looked up
//
// Vectors are of unit length, but a normal may also be zero; then nothing is moved, except by constant_bias. `axis`
// points against the direction in which the light looks: texels of the map are perpendicular to it. `amount` is a
// length in metres; a negative amount moves the other way. Handout, section 5.

// The position, moved by `amount` metres towards the light.
vec3 constant_bias(vec3 position, vec3 to_light, float amount) {
  // TODO(03-shadow-mapping): towards the light
  return position;
}

// The position, moved towards the light as far as is needed to make up for the slope of the surface. A step of `amount`
// metres perpendicular to `axis`, in the steepest direction, ends at a certain distance behind the surface's plane. The
// moved point lies at this distance in front of the plane. The cosine between normal and to_light counts as at least
// 0.01. Directional light (axis = to_light) at 60 degrees to the normal, amount 0.01 m: moved by 0.0173 m.
vec3 slope_bias(vec3 position, vec3 normal, vec3 to_light, vec3 axis, float amount) {
  // TODO(03-shadow-mapping): towards the light; farther, the more the surface is tilted
  return position;
}

// The position, moved by the same distance from the plane, but along the normal. The sign of the angle between normal
// and axis does not matter. The same light, amount 0.01 m: moved by 0.0087 m, however the light falls never by more
// than 0.01 m.
vec3 normal_offset(vec3 position, vec3 normal, vec3 axis, float amount) {
  // TODO(03-shadow-mapping): away from the surface; farther, the more it is tilted in the map
  return position;
}

// (further) (dz/du, dz/dv) of the plane in which dx and dy lie. These are differences of shadow coordinates (u, v, z)
// between neighbouring pixels. (0, 0) where dx.xy and dy.xy are parallel or zero: where the absolute value of their
// determinant is at most 1e-6 |dx.xy| |dy.xy|. Each component is clamped to -100 to 100.
// dx = (0.01, 0, 0.002), dy = (0, 0.02, -0.01): (0.2, -0.5). Handout, section 6.
vec2 plane_slope(vec3 dx, vec3 dy) {
  // TODO(03-shadow-mapping): two linear equations for the two slopes; parallel directions have no solution
  return vec2(0.0);
}

// ---- Many lookups

// Percentage-closer filtering: the mean of PCF x PCF comparisons at the points of a square grid in the map.
// Neighbouring points are one texel apart, and the centre of the grid is the coordinate. Each comparison uses the depth
// that the plane through the coordinate has at its point; slope is (dz/du, dz/dv) of this plane. Handout, section 7.
// You may call: compare_depth.
float pcf(vec3 coordinate, vec2 slope, int layer) {
  // TODO(03-shadow-mapping): the mean over a grid of PCF x PCF points
  return compare_depth(coordinate, layer);
}

// ---- Soft shadows

// (challenge) The depth of a stored depth z, in metres along light.direction from light.eye: z = 0 is the near plane, z
// = 1 the far plane. z was made by the light's projection, so it is linear for a directional light only. near 1 m, far
// 3 m, z = 0.75: a spot light 2 m, a directional light 2.5 m. Handout, section 8.
float linear_depth(ShadowLight light, float z) {
  // TODO(03-shadow-mapping): undo what the projection did to the depth
  return z;
}

// (challenge) The width of the penumbra on a receiver perpendicular to the light, in metres, from linear depths. A spot
// light is a square light.width metres wide; a directional light spans an angle whose tangent is light.width. Handout,
// section 8. A spot light 0.5 m wide, blocker at 2 m, receiver at 3 m: 0.25 m. A directional light with width 0.1: 0.1
// m.
float penumbra_width(ShadowLight light, float receiver, float blocker) {
  // TODO(03-shadow-mapping): similar triangles at the edge of the blocker
  return 0.0;
}

#ifdef PCSS
// (challenge) The mean linear depth of the blockers, in metres; -1 where there are none. SAMPLES points of the map are
// read in a square around the coordinate whose side is `search` (as a fraction of the map's width): sample_point(i) of
// shadows.glsl says where in the square, from -1/2 to 1/2. A blocker is a texel whose stored depth is less than the
// depth of the receiver's plane there; as in pcf, slope is (dz/du, dz/dv). Handout, section 8. You may call:
// linear_depth, sample_point.
float blocker_depth(ShadowLight light, vec3 coordinate, vec2 slope, float search) {
  // TODO(03-shadow-mapping): the mean linear depth of the samples that are nearer to the light than the receiver's plane
  return -1.0;
}

// (challenge) Percentage-closer soft shadows: the mean of SAMPLES comparisons in a square around the coordinate, at the
// points sample_point(i) and with the depths of the receiver's plane there. The square is as wide as the penumbra that
// the mean blocker causes. Blockers are searched in the square that contains every point of the near plane on a line
// from the receiver to the light; it is as wide as the light looks there, and at least 0. `receiver` is the linear
// depth of the point before any bias; a receiver nearer than the blocker gets no penumbra (width 0). In the map, widths
// count as fractions of map_width: of that at the near plane for the search, of that at the receiver for the penumbra.
// 1 where there is no blocker or where coordinate.z > 1. Derivation of the search: handout, section 8. A spot light 0.6
// m wide, near plane 1 m, receiver 1.5 m: 0.2 m are searched. You may call: map_width, blocker_depth, penumbra_width,
// compare_depth, sample_point.
float pcss(ShadowLight light, vec3 coordinate, vec2 slope, float receiver) {
  // TODO(03-shadow-mapping): search for blockers, estimate the penumbra, filter over its width
  return compare_depth(coordinate, light.layer);
}
#endif

// ---- All together

// The fraction of the light that reaches a point, 0 to 1. Step 02's shade gets it from visible_from_spot and
// visible_from_directional. `normal` is of unit length or zero. BIAS chooses how the point is moved: 0 not at all,
// 1 constant_bias, 2 slope_bias, 3 normal_offset, 4 not at all (receiver plane, further). The amount is
// u_bias * FILTER_WIDTH texels, measured at the depth of the point before it is moved. The moved point is looked up:
// - With BIAS other than 0, z of its shadow coordinate is lowered by u_depth_epsilon.
// - With BIAS 4, and with PCSS whatever BIAS is, the slope is that of the receiver's plane, from the derivatives dFdx
// and
//   dFdy of the shadow coordinate. Then z is lowered once more: by u_bias times the largest change of this plane's
//   depth within COMPARISON_HALF_WIDTH texels in u and in v. In all other cases the slope is (0, 0).
// - The result is that of pcf, or that of pcss where PCSS is defined. Handout, sections 4 to 8. You may call: all
// functions above.
float shadow_factor(ShadowLight light, vec3 position, vec3 normal, vec3 to_light) {
  // TODO(03-shadow-mapping): bias, coordinate, slope, then pcf or pcss
  return 1.0;
}
