#include "oracle/frame.hpp"

namespace atelier::oracle {

namespace {

glm::dvec3 axis_least_along(const glm::dvec3& direction) {
  const glm::dvec3 size = glm::abs(direction);
  if (size.x <= size.y && size.x <= size.z) return {1, 0, 0};
  return size.y <= size.z ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
}

}  // namespace

ViewFrame view_frame(const glm::dvec3& direction, const glm::dvec3& up) {
  ViewFrame frame;
  if (direction != glm::dvec3(0)) frame.ahead = glm::normalize(direction);
  frame.right = glm::cross(frame.ahead, up);
  // Parallel within float accuracy: the views compared with this one are computed in floats.
  if (glm::length(frame.right) <= 1e-6 * glm::length(up))
    frame.right = glm::cross(frame.ahead, axis_least_along(frame.ahead));
  frame.right = glm::normalize(frame.right);
  frame.up = glm::cross(frame.right, frame.ahead);
  return frame;
}

}  // namespace atelier::oracle
