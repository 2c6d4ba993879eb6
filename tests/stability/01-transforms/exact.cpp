#include "stability/01-transforms/exact.hpp"

#include <cmath>

namespace atelier::stability::exact {

glm::dvec3 rotated(const glm::dvec3& axis, double angle, const glm::dvec3& v) {
  const double w = std::cos(angle / 2);
  const glm::dvec3 q = std::sin(angle / 2) * (axis / std::hypot(axis.x, axis.y, axis.z));
  const glm::dvec3 t = 2.0 * glm::cross(q, v);  // q v q*, multiplied out for a unit quaternion
  return v + w * t + glm::cross(q, t);
}

glm::dmat3 rotation(const glm::dvec3& axis, double angle) {
  return {rotated(axis, angle, {1, 0, 0}), rotated(axis, angle, {0, 1, 0}), rotated(axis, angle, {0, 0, 1})};
}

glm::dvec3 in_view(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up, const glm::dvec3& point) {
  const glm::dvec3 ahead = glm::normalize(target - eye), upwards = up / std::hypot(up.x, up.y, up.z);
  const glm::dvec3 above = glm::normalize(upwards - glm::dot(upwards, ahead) * ahead);
  const glm::dvec3 right = glm::cross(ahead, above), offset = point - eye;
  return {glm::dot(offset, right), glm::dot(offset, above), -glm::dot(offset, ahead)};
}

double depth(double near, double far, double z) {
  return 1 - 2 * depth_reversed(near, far, z);
}

double depth_reversed(double near, double far, double z) {
  // 1/z - 1/far over 1/near - 1/far, each difference written so that it keeps its digits.
  if (std::isinf(far)) return near / z;
  return near / z * ((far - z) / (far - near));
}

glm::dvec3 normal(const glm::dmat3& model, const glm::dvec3& t1, const glm::dvec3& t2) {
  const glm::dvec3 n = glm::cross(model * t1, model * t2);
  return glm::determinant(model) < 0 ? -n : n;
}

std::vector<glm::dmat4> world_matrices(const std::vector<Joint>& joints) {
  std::vector<glm::dmat4> world;
  for (const Joint& joint : joints) {
    glm::dmat4 m(joint.local);
    for (int parent = joint.parent; parent != -1; parent = joints[std::size_t(parent)].parent)
      m = glm::dmat4(joints[std::size_t(parent)].local) * m;
    world.push_back(m);
  }
  return world;
}

}  // namespace atelier::stability::exact
