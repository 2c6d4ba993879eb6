// The light that a surface reflects, after Blinn ("Models of light reflection for computer synthesized pictures",
// 1977), with normalisation of the highlight after Sloan and Hoffman (Akenine-Moller et al., "Real-Time Rendering").
#pragma once

#include <glm/glm.hpp>

namespace atelier::oracle {

/// The factor that keeps a highlight's energy constant when its exponent n changes.
enum class Normalisation {
  none,      ///< 1
  n_plus_8,  ///< (n + 8) / 8: the usual one; reflects up to 7.5 % more than arrives, at n = 8
  exact,  ///< (n + 2)(n + 4) / (8 (2^(-n/2) + n)): a white highlight reflects exactly what arrives at normal incidence
};

double normalisation_factor(double exponent, Normalisation normalisation);

/// The material of a surface point, with textures applied.
struct Reflectance {
  glm::dvec3 diffuse{0}, specular{0};  ///< kd and ks, linear
  double exponent = 1;                 ///< n >= 0
  Normalisation normalisation = Normalisation::none;
};

/// (kd + ks N(n) (N.H)^n) max(N.L, 0), all three directions of unit length: the fraction of a light's
/// `Arriving::amount` that is reflected to the eye. 0 if N.L <= 0; no highlight if L = -V, since there is no half
/// vector. x^0 is 1. The power is computed from 1 - |N x H|^2 with log1p, which is accurate for cosines close to 1: to
/// 1e-13 at n = 1e6.
glm::dvec3 reflected(const Reflectance& surface, const glm::dvec3& normal, const glm::dvec3& to_eye,
                     const glm::dvec3& to_light);

/// The albedo: the fraction of uniform incident light that the surface reflects towards an eye whose direction has the
/// cosine `cos_eye` to the normal (1: normal incidence). By reciprocity this is the fraction of a single ray that it
/// scatters in all directions. Computes 1/pi times the integral of `reflected` over the hemisphere, by the midpoint
/// rule with `rings` steps from the normal to the horizon and four times as many around it. The error is of order
/// 1/rings^2 once a ring is narrower than the highlight, whose width is about 2/sqrt(n) radians.
glm::dvec3 albedo(const Reflectance& surface, double cos_eye, int rings);

}  // namespace atelier::oracle
