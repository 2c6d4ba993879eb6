#include "oracle/light.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace atelier::oracle {

namespace {

/// Float pi is not exactly pi: treat an angle of about half a turn as exactly that.
double cosine_of(double angle) {
  return angle >= double(std::numbers::pi_v<float>) - 1e-9 ? -1 : std::cos(angle);
}

}  // namespace

double attenuation(double distance, const glm::dvec3& coefficients) {
  const double d = std::max(distance, 0.001);
  return 1 / (coefficients.x + coefficients.y * d + coefficients.z * d * d);
}

double spot_cone(double cosine, double inner_angle, double outer_angle) {
  const double inner = cosine_of(inner_angle), outer = cosine_of(outer_angle);
  if (inner <= outer) return cosine >= outer ? 1 : 0;
  const double t = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Arriving arriving(const Light& light, const glm::dvec3& position) {
  const glm::dvec3 colour(light.colour);
  if (light.type == LightType::directional) return {colour, -glm::normalize(glm::dvec3(light.direction))};

  const glm::dvec3 difference = light.position - position;
  const double distance = glm::length(difference);
  if (distance == 0) return {.distance = 0};
  Arriving found{colour * attenuation(distance, glm::dvec3(light.attenuation)), difference / distance, distance};
  if (light.type == LightType::spot) {
    const double cosine = glm::dot(-found.to_light, glm::normalize(glm::dvec3(light.direction)));
    found.amount *= spot_cone(cosine, double(light.inner_angle), double(light.outer_angle));
  }
  return found;
}

}  // namespace atelier::oracle
