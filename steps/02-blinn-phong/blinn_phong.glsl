// 02-blinn-phong, the fragment shader's part: light that arrives at a surface, and light that leaves it. The contract
// of a function is the comment above it. The letters (E, kd, N, L, ...) are those of the model in blinn_phong.hpp.
// World space, metres, linear light.
//
// Given, in the file included below:
//   Material          vec3 diffuse, specular; float exponent    kd, ks and n
//   PointLight        u_point_lights[POINT_LIGHTS]              position, colour, attenuation (the coefficients c)
//   SpotLight         u_spot_lights[SPOT_LIGHTS]                the same, direction (of its axis) and cosines
//   DirectionalLight  u_directional_lights[DIRECTIONAL_LIGHTS]  direction, colour
//   vec3              u_ambient                                 the ambient light
//   float visible_from_point(int i), visible_from_spot(int i), visible_from_directional(int i)
//   sampler2D         u_power_table                             only where POWER is 2
// SPECULAR, and with it NORMALISATION and POWER, are defined only where the material has a highlight; without it the
// two are 0 in #if. POINT_LIGHTS, SPOT_LIGHTS and DIRECTIONAL_LIGHTS are the numbers of lights in the scene. Where one
// is 0, there is no such array: put what uses it between #if POINT_LIGHTS > 0 and #endif.
#include "02-blinn-phong/given/lights.glsl"

// ---- Light that arrives

// The factor by which distance weakens a light: 1 / (c.x + c.y d + c.z d^2). c are the coefficients, d is the distance
// in metres; below 0.001 m it counts as 0.001 m. Handout, section 5.
float attenuation(float distance, vec3 coefficients) {
  // TODO(02-blinn-phong): one over a polynomial of the distance, which is at least a millimetre
  return 1.0;
}

// The fraction of a spot light's light that goes in this direction: 1 inside the inner cone, 0 outside the outer cone.
// Between the two it is 3t^2 - 2t^3, where t grows linearly with the cosine of the angle to the axis, from 0 at
// cos_outer to 1 at cos_inner. to_light and axis are of unit length; the light travels along the axis. Equal cosines: a
// hard edge, and the edge itself is lit. Cosines of -1: every direction is lit, although a rounded cosine may be below
// -1. Handout, section 5.
float spot_cone(vec3 to_light, vec3 axis, float cos_inner, float cos_outer) {
  // TODO(02-blinn-phong): use the cosine of the angle to the axis; smoothstep is undefined where its edges are equal
  return 1.0;
}

// E of a point light at a position: its colour, weakened by the distance. Also sets to_light, the unit vector from the
// position to the light. A light exactly at the position gives no light, and to_light is any unit vector.
// Handout, section 5. You may call: attenuation.
vec3 arriving_from_point(PointLight light, vec3 position, out vec3 to_light) {
  // TODO(02-blinn-phong): the unit vector to the light, and its colour weakened by the distance
  to_light = vec3(0.0, 1.0, 0.0);
  return vec3(0.0);
}

// The same for a spot light: a point light that shines only inside its cone. light.direction is the axis of the cone,
// light.cosines holds (cos_inner, cos_outer).
// Handout, section 5. You may call: arriving_from_point, spot_cone.
vec3 arriving_from_spot(SpotLight light, vec3 position, out vec3 to_light) {
  // TODO(02-blinn-phong): a point light inside a cone
  to_light = vec3(0.0, 1.0, 0.0);
  return vec3(0.0);
}

// The same for a directional light, which is equally strong everywhere. Its light travels along light.direction.
// Handout, section 5.
vec3 arriving_from_direction(DirectionalLight light, vec3 position, out vec3 to_light) {
  // TODO(02-blinn-phong): the same everywhere
  to_light = vec3(0.0, 1.0, 0.0);
  return vec3(0.0);
}

// ---- Light that leaves

// (further) N(n) of the model: the factor of a highlight with this exponent, 0 to 1e6. NORMALISATION chooses it:
//   0  none: 1. The core tier needs only this.
//   1  the usual one: (n + 8) / 8.
//   2  the exact one: a white highlight (kd = 0, ks = 1) then reflects all the light that arrives along the normal.
//      N(0) = 1, N(8) = 1.8605.
// Handout, section 4.
float specular_normalisation(float exponent) {
  // TODO(02-blinn-phong): 1, or the factor that keeps the energy, by NORMALISATION
  return 1.0;
}

// max(N.H, 0)^n for vectors of unit length, and 1 for an exponent of 0, whatever the vectors are. A zero vector counts
// as N.H = 0. POWER chooses how it is computed:
//   0  in any way.
//   1  (further) for exponents up to 1e6, with an error of at most 0.1 % of values above 0.05. In 32 bits the cosine of
//      a small angle is not exact enough for that: handout, section 8.
//   2  (challenge) from u_power_table: one row, whose red texels are the entries of power_table. Between the entries it
//      is interpolated linearly; N.H = 1 gives exactly the last entry. Handout, section 9.
float highlight(vec3 normal, vec3 half_vector, float exponent) {
  // TODO(02-blinn-phong): the cosine to the power of the exponent, by POWER; pow(0, 0) is undefined
  return 0.0;
}

// What the surface sends to the eye when light of E = 1 arrives: (kd + ks N(n) max(N.H, 0)^n) max(N.L, 0). The vectors
// are of unit length. N.L <= 0, also from a zero normal, gives 0. Where to_light = -to_eye there is no H and no
// highlight. Keep the highlight between #ifdef SPECULAR and #endif: then materials without one get a shader without it.
// Handout, sections 1 and 2. You may call: specular_normalisation, highlight.
vec3 reflected(vec3 normal, vec3 to_eye, vec3 to_light, Material m) {
  // TODO(02-blinn-phong): diffuse and specular part, times N.L; nothing from behind
  return vec3(0.0);
}

// The light that leaves the surface towards the eye: the model's sum over all lights, without the emission, which is
// added later. `normal` was interpolated, so its length is not 1. A zero normal, or an eye at the position, leaves only
// the ambient part. The visibility s of light i is visible_from_point(i), visible_from_spot(i) or
// visible_from_directional(i) of lights.glsl, where i is its index in its array. It weakens only this light.
// Handout, sections 1 and 3. You may call: the three arriving_from_ functions, reflected.
vec3 shade(vec3 position, vec3 normal, vec3 eye, Material m) {
  vec3 sum = m.diffuse * u_ambient;
  // TODO(02-blinn-phong): make normal and to_eye unit vectors, then add what is visible of every light of every type
  return sum;
}

// ---- Colour

// Linear light to its sRGB code, each component separately: as srgb_encode in blinn_phong.hpp.
vec3 srgb_encode(vec3 linear) {
  // TODO(02-blinn-phong): the two branches of the curve, chosen for each component
  return linear;
}

// The inverse: as srgb_decode in blinn_phong.hpp.
vec3 srgb_decode(vec3 encoded) {
  // TODO(02-blinn-phong): the inverse
  return encoded;
}
