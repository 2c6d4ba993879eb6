#include "render/cull.hpp"

#include <array>
#include <cmath>

namespace atelier {

namespace {

/// Float error bound of three matrix-vector products, relative to the sum of the terms' magnitudes: each has four
/// rounding errors of 2^-24, together 12 * 6e-8 = 7.2e-7 (Higham, "Accuracy and Stability of Numerical Algorithms",
/// section 3.5). Multiplying the matrices first has the same bound.
constexpr double rounding = 1e-6;

glm::dmat4 magnitudes(const glm::mat4& m) {
  return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2]), glm::abs(m[3])};
}

}  // namespace

bool outside_view(const glm::mat4& projection, const glm::mat4& view, const glm::mat4& model, const Box3& box,
                  bool depth_from_zero) {
  if (box.empty()) return true;
  const glm::dmat4 to_clip = glm::dmat4(projection) * glm::dmat4(view) * glm::dmat4(model);
  // The sums of magnitudes of the terms that the shader adds, without cancellation.
  const glm::dmat4 to_largest = magnitudes(projection) * magnitudes(view) * magnitudes(model);
  // The planes -w <= x, x <= w ... are linear in clip space: if all corners of a box are outside a plane, the whole box
  // is, wherever the eye is. There is no division by w, which may be zero or negative. The slack is a convex function
  // (a sum of magnitudes), so between the corners it is at most the mean of theirs.
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
