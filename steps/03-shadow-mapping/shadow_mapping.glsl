// 03-shadow-mapping, the lookup: which fraction of a light reaches a point. The contract of a function is the comment
// above it. World space and metres, unless it says "in the map": there u and v go from 0 to 1 across the map, and z is
// the depth, from 0 to 1.
//
// Given, in the file included below:
//   ShadowLight            mat4 world_to_map; vec3 eye, direction; float half_width, near, far, width;
//                          bool directional; int layer
//   u_shadow_maps          texture(u_shadow_maps, vec3(u, v, layer)).r is the stored depth; where COMPARE is defined,
//                          texture(u_shadow_maps, vec4(u, v, layer, z)) is a float, the answer of the comparison
//   float u_bias           the bias in texels, for one comparison with one texel
//   float u_depth_epsilon  how much equal depths may differ after rounding
//   FILTER_WIDTH           a float: the side of the square of texels on which all PCF x PCF comparisons depend
//   COMPARISON_HALF_WIDTH  a float: half the side of the square of texels on which one comparison depends
//   SAMPLES, and vec2 sample_point(int i)   only where PCSS is defined
// PCF and BIAS are always defined, as whole numbers; COMPARE and PCSS are defined or not.
#include "03-shadow-mapping/given/shadows.glsl"

// ---- One lookup

// Where a point is in the map: (u, v, z). world_to_map takes world space to homogeneous coordinates; divided by w they
// are u, v and z. A point with w <= 0 is not in front of the light: (0, 0, 2). z is at most 1: a point beyond the far
// plane is compared as if it were on it. A point in front of the near plane has z < 0. Handout, section 2.
vec3 shadow_coordinate(mat4 world_to_map, vec3 position) {
  // TODO(03-shadow-mapping): from homogeneous coordinates to (u, v, z)
  return vec3(0.0, 0.0, 2.0);
}

// The width of the square that the map covers at this depth, in metres. `depth` is measured along light.direction from
// light.eye. A spot light with half_width 0.5: 3 m at a depth of 3 m. A directional light with half_width 4: 8 m at
// every depth. Handout, section 4.
float map_width(ShadowLight light, float depth) {
  // TODO(03-shadow-mapping): a spot light sees a pyramid, a directional light a box
  return 1.0;
}

// 1 where z of the coordinate is at most the depth that is stored at (u, v) in this layer, otherwise 0. 1 where z is
// above 1. Outside of the map the texture itself returns its border, which is 1. With COMPARE the sampler u_shadow_maps
// compares: it takes (u, v, layer, z) and returns the answers of the four nearest texels, interpolated. Handout,
// sections 1 and 7.
float compare_depth(vec3 coordinate, int layer) {
  // TODO(03-shadow-mapping): compare z with the depth that is stored at (u, v), with and without COMPARE
  return 1.0;
}

// ---- Bias: the point is moved before it is looked up
//
// Vectors are of unit length, but a normal may also be zero; then nothing is moved, except by constant_bias. `axis`
// points against the direction in which the light looks: texels of the map are perpendicular to it. `amount` is a
// length in metres; a negative amount moves the other way. Handout, section 5. Get sines from cross products and cosines
// from dot products: acos in GLSL is wrong in the fourth digit.

// The position, moved by `amount` metres towards the light.
vec3 constant_bias(vec3 position, vec3 to_light, float amount) {
  // TODO(03-shadow-mapping): towards the light
  return position;
}

// The position, moved along to_light until it is far enough in front of its plane. How far: a step of `amount` metres
// perpendicular to `axis` leaves the plane of the surface, by most in the steepest direction. The moved point is in
// front of the plane by this largest distance. The cosine of the angle between normal and to_light counts as at least
// 0.01, also where the normal points away from the light. Directional light (axis = to_light) at 60 degrees to the
// normal, amount 0.01 m: moved by 0.0173 m.
vec3 slope_bias(vec3 position, vec3 normal, vec3 to_light, vec3 axis, float amount) {
  // TODO(03-shadow-mapping): towards the light; farther, the more the surface is tilted
  return position;
}

// The position, moved along `normal` by the largest distance by which a step of `amount` metres perpendicular to `axis`
// leaves the plane of the surface. `normal` is not turned round where it points away from the light. 60 degrees between
// normal and axis, amount 0.01 m: moved by 0.0087 m.
vec3 normal_offset(vec3 position, vec3 normal, vec3 axis, float amount) {
  // TODO(03-shadow-mapping): away from the surface; farther, the more it is tilted in the map
  return position;
}

// (further) (dz/du, dz/dv) of the plane of the surface in the map. dx and dy are differences of shadow coordinates (u,
// v, z) between neighbouring pixels; both lie in the plane. (0, 0) where dx.xy and dy.xy are zero or parallel: where
// the absolute value of their determinant is at most 1e-6 |dx.xy| |dy.xy|. Each component is clamped to -100..100. dx =
// (0.01, 0, 0.002), dy = (0, 0.02, -0.01): (0.2, -0.5). Handout, section 6.
vec2 plane_slope(vec3 dx, vec3 dy) {
  // TODO(03-shadow-mapping): two linear equations for the two slopes; parallel directions have no solution
  return vec2(0.0);
}

// ---- Many lookups

// Percentage-closer filtering: the mean of PCF x PCF comparisons, at the points of a square grid in the map.
// Neighbouring points are one texel apart; the centre of the grid is the coordinate. Each comparison uses the depth of
// the plane through the coordinate at its point; slope is (dz/du, dz/dv) of this plane.
// Handout, section 7. You may call: compare_depth.
float pcf(vec3 coordinate, vec2 slope, int layer) {
  // TODO(03-shadow-mapping): the mean over a grid of PCF x PCF points
  return compare_depth(coordinate, layer);
}

// ---- Soft shadows

// (challenge) The distance that belongs to a stored depth z, in metres along light.direction from light.eye: that of
// the near plane for z = 0, that of the far plane for z = 1. z is what the projection of the light has made of it, so
// it is linear only for a directional light. near = 1 m, far = 3 m, z = 0.75: 2 m for a spot light, 2.5 m for a
// directional light. Handout, section 8.
float linear_depth(ShadowLight light, float z) {
  // TODO(03-shadow-mapping): undo what the projection did to the depth
  return z;
}

// (challenge) The width of the penumbra on a receiver perpendicular to the light, in metres, from linear depths. The
// source of a spot light is a square light.width metres wide; a directional light spans an angle with this tangent.
// Spot light 0.5 m wide, blocker at 2 m, receiver at 3 m: 0.25 m. Directional light with width 0.1, the same depths:
// 0.1 m. Handout, section 8.
float penumbra_width(ShadowLight light, float receiver, float blocker) {
  // TODO(03-shadow-mapping): similar triangles at the edge of the blocker
  return 0.0;
}

#ifdef PCSS
// (challenge) The mean linear depth of the blockers, in metres; -1 where there are none. SAMPLES texels are read in a
// square around the coordinate. `search` is its side, as a fraction of the map's width; sample_point(i) of shadows.glsl
// says where in the square, -1/2 to 1/2. A blocker is a texel whose stored depth is less than the depth of the
// receiver's plane at that point. slope is (dz/du, dz/dv) of this plane, as in pcf.
// Handout, section 8. You may call: linear_depth, sample_point.
float blocker_depth(ShadowLight light, vec3 coordinate, vec2 slope, float search) {
  // TODO(03-shadow-mapping): the mean linear depth of the samples that are nearer to the light than the receiver's plane
  return -1.0;
}

// (challenge) Percentage-closer soft shadows: the mean of SAMPLES comparisons over a square that is as wide as the
// penumbra. `receiver` is the linear depth of the point before any bias. 1 where coordinate.z > 1, or without blockers.
// - The search for blockers covers that square of the near plane through which all lines from the point to the light
//   go; its width is at least 0. Spot light 0.6 m wide, near plane at 1 m, receiver at 1.5 m: a square of 0.2 m.
// - The penumbra is that of the mean blocker. A receiver nearer than this blocker has a penumbra of width 0.
// - Both squares are centred at the coordinate; points and depths are as in blocker_depth. A width in metres becomes a
//   fraction of the map's width: the search of map_width at the near plane, the penumbra of map_width at the receiver.
// Handout, section 8. You may call: map_width, blocker_depth, penumbra_width, compare_depth, sample_point.
float pcss(ShadowLight light, vec3 coordinate, vec2 slope, float receiver) {
  // TODO(03-shadow-mapping): search for blockers, estimate the penumbra, filter over its width
  return compare_depth(coordinate, light.layer);
}
#endif

// ---- All together

// The fraction of the light that reaches a point, 0 to 1. Step 02's shade gets it from visible_from_spot and
// visible_from_directional. `normal` is of unit length or zero.
// - BIAS chooses how the point is moved before it is looked up: 1 constant_bias, 2 slope_bias, 3 normal_offset; with 0
//   (none) and 4 (receiver plane, further) it is not moved. The amount is u_bias * FILTER_WIDTH texels, a texel as wide
//   as it is at the depth of the point before it is moved.
// - With BIAS other than 0, z of the shadow coordinate is lowered by u_depth_epsilon.
// - With BIAS 4, and with PCSS beside every BIAS, the slope is that of the receiver's plane, from the derivatives dFdx
//   and dFdy of the shadow coordinate. z is then lowered once more, by u_bias times the largest change of this plane's
//   depth over a step of up to COMPARISON_HALF_WIDTH texels in u and as many in v: that to a corner of the square. In
//   all other cases the slope is (0, 0).
// - The result is that of pcf, or that of pcss where PCSS is defined, also where the normal points away from the light.
// Handout, sections 4 to 8. You may call: all functions above.
float shadow_factor(ShadowLight light, vec3 position, vec3 normal, vec3 to_light) {
  // TODO(03-shadow-mapping): bias, coordinate, slope, then pcf or pcss
  return 1.0;
}
