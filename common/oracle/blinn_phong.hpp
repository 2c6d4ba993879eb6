// The light that leaves a surface, after Blinn ("Models of light reflection for computer synthesized pictures", 1977),
// with the energy of the highlight after Sloan and Hoffman (Akenine-Moller et al., "Real-Time Rendering").
#pragma once

#include <glm/glm.hpp>

namespace atelier::oracle {

/// The factor that keeps a highlight's energy while its exponent n changes.
enum class Normalisation {
  none,      ///< 1
  n_plus_8,  ///< (n + 8) / 8: the usual one; gives back up to 7.5 % more than it got, at n = 8
  exact,     ///< (n + 2)(n + 4) / (8 (2^(-n/2) + n)): a white highlight, seen straight on, gives back just what it got
};

double normalisation_factor(double exponent, Normalisation normalisation);

/// How a point of a surface answers light, textures included.
struct Reflectance {
  glm::dvec3 diffuse{0}, specular{0};  ///< kd and ks, linear
  double exponent = 1;                 ///< n >= 0
  Normalisation normalisation = Normalisation::none;
};

/// (kd + ks N(n) (N.H)^n) max(N.L, 0), all three directions of unit length: what of a light's `Arriving::amount` goes
/// to the eye. Nothing where N.L <= 0; no highlight where L = -V, which leaves no half vector. x^0 is 1. The power is
/// taken of 1 - |N x H|^2 by log1p, which keeps its digits where the cosine is close to 1: to 1e-13 at n = 1e6.
glm::dvec3 reflected(const Reflectance& surface, const glm::dvec3& normal, const glm::dvec3& to_eye,
                     const glm::dvec3& to_light);

/// The albedo: how much of evenly arriving light the surface gives back towards an eye at `cos_eye` from the normal
/// (1: straight on). By reciprocity that is the share of a single ray that it scatters in all directions. The integral
/// 1/pi of `reflected` over the hemisphere, by the midpoint rule with `rings` steps from the normal to the horizon and
/// four times as many around it: an error of the order 1/rings^2, once a ring is narrower than the highlight, whose
/// width is about 2/sqrt(n) radians.
glm::dvec3 albedo(const Reflectance& surface, double cos_eye, int rings);

}  // namespace atelier::oracle
