// 02-blinn-phong, the fragment shader's part: light that arrives, and light that leaves. What each function must do stands
// in blinn_phong.hpp; the structs are these:
#include "02-blinn-phong/lights.glsl"

// ---- Light that arrives

float attenuation(float distance, vec3 coefficients) {
  // TODO(02-blinn-phong): one over a polynomial of the distance, which is at least a millimetre
  return 1.0;
}

float spot_cone(vec3 to_light, vec3 axis, float cos_inner, float cos_outer) {
  // TODO(02-blinn-phong): compare the cosine of the angle off the axis; smoothstep is undefined where its edges are equal
  return 1.0;
}

vec3 arriving_from_point(PointLight light, vec3 position, out vec3 to_light) {
  // TODO(02-blinn-phong): the unit vector to the light, and its colour weakened by the distance
  to_light = vec3(0.0, 1.0, 0.0);
  return vec3(0.0);
}

vec3 arriving_from_spot(SpotLight light, vec3 position, out vec3 to_light) {
  // TODO(02-blinn-phong): a point light within a cone
  to_light = vec3(0.0, 1.0, 0.0);
  return vec3(0.0);
}

vec3 arriving_from_direction(DirectionalLight light, vec3 position, out vec3 to_light) {
  // TODO(02-blinn-phong): the same everywhere
  to_light = vec3(0.0, 1.0, 0.0);
  return vec3(0.0);
}

// ---- Light that leaves

float specular_normalisation(float exponent) {
  // TODO(02-blinn-phong): 1, or the factor that keeps the energy, by NORMALISATION
  return 1.0;
}

float highlight(vec3 normal, vec3 half_vector, float exponent) {
  // TODO(02-blinn-phong): the cosine to the power of the exponent, by POWER; pow(0, 0) is undefined
  return 0.0;
}

vec3 reflected(vec3 normal, vec3 to_eye, vec3 to_light, Material m) {
  // TODO(02-blinn-phong): diffuse and specular part, times N.L; nothing from behind
  return vec3(0.0);
}

vec3 shade(vec3 position, vec3 normal, vec3 eye, Material m) {
  vec3 sum = m.diffuse * u_ambient;
  // TODO(02-blinn-phong): make normal and to_eye unit vectors, then add what is visible of every light of every type
  return sum;
}

// ---- Colour

vec3 srgb_encode(vec3 linear) {
  // TODO(02-blinn-phong): the two branches of the curve, chosen for each component
  return linear;
}

vec3 srgb_decode(vec3 encoded) {
  // TODO(02-blinn-phong): the inverse
  return encoded;
}
