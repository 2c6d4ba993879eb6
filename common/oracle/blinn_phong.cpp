#include "oracle/blinn_phong.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace atelier::oracle {

namespace {

/// (N.H)^n, and 0 where N.H <= 0 unless n = 0.
double highlight(const glm::dvec3& normal, const glm::dvec3& half_vector, double exponent) {
  if (exponent == 0) return 1;
  if (glm::dot(normal, half_vector) <= 0) return 0;
  const glm::dvec3 sine = glm::cross(normal, half_vector);
  return std::exp(exponent / 2 * std::log1p(-std::min(glm::dot(sine, sine), 1.0)));
}

}  // namespace

double normalisation_factor(double exponent, Normalisation normalisation) {
  const double n = exponent;
  if (normalisation == Normalisation::n_plus_8) return (n + 8) / 8;
  if (normalisation == Normalisation::exact) return (n + 2) * (n + 4) / (8 * (std::exp2(-n / 2) + n));
  return 1;
}

glm::dvec3 reflected(const Reflectance& surface, const glm::dvec3& normal, const glm::dvec3& to_eye,
                     const glm::dvec3& to_light) {
  const double n_dot_l = glm::dot(normal, to_light);
  if (n_dot_l <= 0) return glm::dvec3(0);
  glm::dvec3 share = surface.diffuse;
  const glm::dvec3 between = to_light + to_eye;
  const double length = glm::length(between);
  if (length > 0 && surface.specular != glm::dvec3(0))
    share += surface.specular * (normalisation_factor(surface.exponent, surface.normalisation) *
                                 highlight(normal, between / length, surface.exponent));
  return share * n_dot_l;
}

glm::dvec3 albedo(const Reflectance& surface, double cos_eye, int rings) {
  constexpr double pi = glm::pi<double>();
  const glm::dvec3 normal(0, 0, 1), to_eye(std::sqrt(std::max(0.0, 1 - cos_eye * cos_eye)), 0, cos_eye);
  const int around = cos_eye == 1 ? 1 : 4 * rings;  // rotationally symmetric at normal incidence
  const double step = pi / 2 / rings;
  glm::dvec3 sum(0);
  for (int ring = 0; ring < rings; ++ring) {
    const double theta = (ring + 0.5) * step;
    for (int i = 0; i < around; ++i) {
      const double phi = 2 * pi * (i + 0.5) / around;
      const glm::dvec3 to_light(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      sum += reflected(surface, normal, to_eye, to_light) * std::sin(theta);
    }
  }
  return sum * (step * 2 * pi / around / pi);
}

}  // namespace atelier::oracle
