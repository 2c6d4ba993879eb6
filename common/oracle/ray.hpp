// A ray, and the stretch of it that counts.
#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace atelier::oracle {

/// The points origin + t direction, least <= t <= most. The direction may have any length but zero: t is measured in
/// its length, so that a camera can have t mean the distance along its axis, and a shadow ray 1 mean the light.
struct Ray {
  glm::dvec3 origin{0}, direction{0, 0, -1};
  double least = 0, most = std::numeric_limits<double>::infinity();

  glm::dvec3 at(double t) const { return origin + t * direction; }
};

}  // namespace atelier::oracle
