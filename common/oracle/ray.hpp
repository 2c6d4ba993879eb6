// A ray and its interval.
#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace atelier::oracle {

/// The points origin + t direction, least <= t <= most. The direction may have any length except zero; t is in units of
/// it. So t can be the distance along a camera's axis, or 1 at the light for a shadow ray.
struct Ray {
  glm::dvec3 origin{0}, direction{0, 0, -1};
  double least = 0, most = std::numeric_limits<double>::infinity();

  glm::dvec3 at(double t) const { return origin + t * direction; }
};

}  // namespace atelier::oracle
