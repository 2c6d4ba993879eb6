// The right and up directions of a view: for a camera, or a light with an extent.
#pragma once

#include <glm/glm.hpp>

namespace atelier::oracle {

/// Three orthonormal directions: right = ahead x up.
struct ViewFrame {
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, ahead{0, 0, -1};
};

/// Looks along `direction` with `up` pointing upwards; both may have any length. If up is parallel to the direction, it
/// is replaced by the first of the axes x, y, z with the smallest |component| of the direction, as in the contract of
/// step 01. If the direction is zero, it looks along -z.
ViewFrame view_frame(const glm::dvec3& direction, const glm::dvec3& up);

}  // namespace atelier::oracle
