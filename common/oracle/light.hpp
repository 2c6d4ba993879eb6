// The light that arrives at a point.
#pragma once

#include <glm/glm.hpp>
#include <limits>

#include "scene/scene.hpp"

namespace atelier::oracle {

struct Arriving {
  glm::dvec3 amount{0};          ///< linear colour; divided by pi as the course has it: colour 1 makes white look 1
  glm::dvec3 to_light{0, 1, 0};  ///< of unit length
  double distance = std::numeric_limits<double>::infinity();  ///< metres to the light; infinite for directional lights
};

/// What a light sends to a position in world space where nothing stands between.
///   point         colour / (c + l d + q d^2); a distance d below a millimetre counts as one
///   spot          the same times the cone: 1 within the inner angle, 0 beyond the outer one, 3t^2 - 2t^3 of the cosine
///                 between; where both angles are equal a hard edge, lit on it
///   directional   colour
/// A light exactly at the position gives nothing.
Arriving arriving(const Light& light, const glm::dvec3& position);

/// 1 / (c.x + c.y d + c.z d^2), metres.
double attenuation(double distance, const glm::dvec3& coefficients);

/// The share of a spot light that goes where the cosine of the angle off its axis is `cosine`; angles in radians.
double spot_cone(double cosine, double inner_angle, double outer_angle);

}  // namespace atelier::oracle
