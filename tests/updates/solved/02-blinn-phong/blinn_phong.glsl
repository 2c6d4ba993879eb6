// 02-blinn-phong, the fragment shader's part: light that arrives, and light that leaves. What each function must do stands
// in blinn_phong.hpp; the structs are these:
#include "02-blinn-phong/lights.glsl"

// ---- Light that arrives

float attenuation(float distance, vec3 coefficients) {
  float d = max(distance, 0.001);
  return 1.0 / (coefficients.x + coefficients.y * d + coefficients.z * d * d);
}

float spot_cone(vec3 to_light, vec3 axis, float cos_inner, float cos_outer) {
  float cosine = clamp(dot(-to_light, axis), -1.0, 1.0);  // rounding must not leave a cone of 180 degrees
  if (cos_inner <= cos_outer) return cosine >= cos_outer ? 1.0 : 0.0;
  return smoothstep(cos_outer, cos_inner, cosine);
}

vec3 arriving_from_point(PointLight light, vec3 position, out vec3 to_light) {
  vec3 difference = light.position - position;
  float distance = length(difference);
  to_light = distance > 0.0 ? difference / distance : vec3(0.0, 1.0, 0.0);
  return distance > 0.0 ? light.colour * attenuation(distance, light.attenuation) : vec3(0.0);
}

vec3 arriving_from_spot(SpotLight light, vec3 position, out vec3 to_light) {
  vec3 arriving = arriving_from_point(PointLight(light.position, light.colour, light.attenuation), position, to_light);
  return arriving * spot_cone(to_light, light.direction, light.cosines.x, light.cosines.y);
}

vec3 arriving_from_direction(DirectionalLight light, vec3 position, out vec3 to_light) {
  to_light = -light.direction;
  return light.colour;
}

// ---- Light that leaves

float specular_normalisation(float exponent) {
#if NORMALISATION == 1
  return (exponent + 8.0) / 8.0;
#elif NORMALISATION == 2
  return (exponent + 2.0) * (exponent + 4.0) / (8.0 * (exp2(-exponent / 2.0) + exponent));
#else
  return 1.0;
#endif
}

float highlight(vec3 normal, vec3 half_vector, float exponent) {
  if (exponent == 0.0) return 1.0;
  float cosine = max(dot(normal, half_vector), 0.0);
#if POWER == 1
  // cos^n = (1 - sin^2)^(n/2). A cosine near 1 cannot hold a small angle in 24 bits; the cross product can.
  vec3 sine = cross(normal, half_vector);
  float s = min(dot(sine, sine), 1.0);
  float logarithm = s < 0.01 ? -s * (1.0 + s * (0.5 + s * (1.0 / 3.0 + s * 0.25))) : log(1.0 - s);
  return cosine > 0.0 ? exp(0.5 * exponent * logarithm) : 0.0;
#elif POWER == 2
  float size = float(textureSize(u_power_table, 0).x);
  return texture(u_power_table, vec2((cosine * (size - 1.0) + 0.5) / size, 0.5)).r;
#else
  return cosine > 0.0 ? pow(cosine, exponent) : 0.0;
#endif
}

vec3 reflected(vec3 normal, vec3 to_eye, vec3 to_light, Material m) {
  float n_dot_l = dot(normal, to_light);
  if (n_dot_l <= 0.0) return vec3(0.0);
  vec3 share = m.diffuse;
#ifdef SPECULAR
  vec3 between = to_light + to_eye;
  float length_squared = dot(between, between);
  if (length_squared > 0.0)
    share += m.specular * specular_normalisation(m.exponent) * highlight(normal, between * inversesqrt(length_squared), m.exponent);
#endif
  return share * n_dot_l;
}

vec3 shade(vec3 position, vec3 normal, vec3 eye, Material m) {
  vec3 sum = m.diffuse * u_ambient;
  vec3 eye_difference = eye - position;
  if (dot(normal, normal) == 0.0 || dot(eye_difference, eye_difference) == 0.0) return sum;
  vec3 n = normalize(normal), to_eye = normalize(eye_difference), to_light;
#if POINT_LIGHTS > 0
  for (int i = 0; i < POINT_LIGHTS; ++i) {
    vec3 arriving = arriving_from_point(u_point_lights[i], position, to_light) * visible_from_point(i);
    sum += arriving * reflected(n, to_eye, to_light, m);
  }
#endif
#if SPOT_LIGHTS > 0
  for (int i = 0; i < SPOT_LIGHTS; ++i) {
    vec3 arriving = arriving_from_spot(u_spot_lights[i], position, to_light) * visible_from_spot(i);
    sum += arriving * reflected(n, to_eye, to_light, m);
  }
#endif
#if DIRECTIONAL_LIGHTS > 0
  for (int i = 0; i < DIRECTIONAL_LIGHTS; ++i) {
    vec3 arriving = arriving_from_direction(u_directional_lights[i], position, to_light) * visible_from_directional(i);
    sum += arriving * reflected(n, to_eye, to_light, m);
  }
#endif
  return sum;
}

// ---- Colour

vec3 srgb_encode(vec3 linear) {
  vec3 x = max(linear, 0.0);
  return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, vec3(lessThanEqual(x, vec3(0.0031308))));
}

vec3 srgb_decode(vec3 encoded) {
  vec3 x = max(encoded, 0.0);
  return mix(pow((x + 0.055) / 1.055, vec3(2.4)), x / 12.92, vec3(lessThanEqual(x, vec3(0.04045))));
}
