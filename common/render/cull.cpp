#include "render/cull.hpp"

#include <array>
#include <cmath>

namespace atelier {

namespace {

/// How far floats may be off after three products of a matrix and a column, as a share of the sum of the terms'
/// magnitudes: each takes four roundings of 2^-24, which makes 12 * 6e-8 = 7.2e-7 (Higham, "Accuracy and Stability of
/// Numerical Algorithms", section 3.5). Multiplying the matrices first comes to the same.
constexpr double rounding = 1e-6;

glm::dmat4 magnitudes(const glm::mat4& m) {
  return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2]), glm::abs(m[3])};
}

}  // namespace

bool outside_view(const glm::mat4& projection, const glm::mat4& view, const glm::mat4& model, const Box3& box,
                  bool depth_from_zero) {
  if (box.empty()) return true;
  const glm::dmat4 to_clip = glm::dmat4(projection) * glm::dmat4(view) * glm::dmat4(model);
  // The sums of magnitudes: what the shader adds up, without what cancels.
  const glm::dmat4 to_largest = magnitudes(projection) * magnitudes(view) * magnitudes(model);
  // The planes -w <= x, x <= w ... are linear in clip space, so a plane that has all corners of a box outside has all
  // of the box outside, wherever the eye is: no division by w, which may be zero or negative. So too with
  // the slack: as a sum of magnitudes it is, between the corners, at most the mean of theirs.
  std::array<bool, 6> all_outside;
  all_outside.fill(true);
  for (const glm::dvec3& corner : corners_of(box)) {
    const glm::dvec4 p(corner, 1);
    const glm::dvec4 c = to_clip * p, largest = to_largest * glm::abs(p);
    const auto beyond = [&](int axis, double sign, double limit, double limit_size) {
      return sign * c[axis] - limit > rounding * (largest[axis] + limit_size);
    };
    for (int axis = 0; axis < 3; ++axis) {
      const bool from_zero = axis == 2 && depth_from_zero;
      const bool low = from_zero ? beyond(axis, -1, 0, 0) : beyond(axis, -1, c.w, largest.w);
      all_outside[std::size_t(2 * axis)] &= low;
      all_outside[std::size_t(2 * axis + 1)] &= beyond(axis, 1, c.w, largest.w);
    }
  }
  for (const bool outside : all_outside)
    if (outside) return true;
  return false;
}

}  // namespace atelier
