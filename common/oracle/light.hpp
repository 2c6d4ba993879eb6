// The incident light at a point.
#pragma once

#include <glm/glm.hpp>
#include <limits>

#include "scene/scene.hpp"

namespace atelier::oracle {

struct Arriving {
  glm::dvec3 amount{
      0};  ///< linear colour; in the course's units (divided by pi): colour 1 makes a white surface look 1
  glm::dvec3 to_light{0, 1, 0};                               ///< of unit length
  double distance = std::numeric_limits<double>::infinity();  ///< metres to the light; infinite for directional lights
};

/// The unoccluded light from a light source at a position in world space.
///   point         colour / (c + l d + q d^2); a distance d below a millimetre counts as one
///   spot          the same times the cone: 1 within the inner angle, 0 beyond the outer one, 3t^2 - 2t^3 of the cosine
///                 between; if both angles are equal a hard edge, lit on it
///   directional   colour
/// 0 for a light exactly at the position.
Arriving arriving(const Light& light, const glm::dvec3& position);

/// 1 / (c.x + c.y d + c.z d^2), metres.
double attenuation(double distance, const glm::dvec3& coefficients);

/// The spot factor, 0..1, in a direction whose angle to the axis has the cosine `cosine`; angles in radians.
double spot_cone(double cosine, double inner_angle, double outer_angle);

}  // namespace atelier::oracle
