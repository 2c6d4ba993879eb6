// Which way is right and which is up for who looks along a direction: a camera, or a light with an extent.
#pragma once

#include <glm/glm.hpp>

namespace atelier::oracle {

/// Three directions of unit length, square to each other: right = ahead x up.
struct ViewFrame {
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, ahead{0, 0, -1};
};

/// Looks along `direction` with `up` pointing upwards; neither need be of unit length. Where up is parallel to the
/// direction, the first of the axes x, y, z with the smallest |component| of the direction stands in, as the contract
/// of step 01 has it; where the direction is zero, it looks along -z.
ViewFrame view_frame(const glm::dvec3& direction, const glm::dvec3& up);

}  // namespace atelier::oracle
