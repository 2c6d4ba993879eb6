#include "render/cull.hpp"

#include <array>
#include <cmath>

namespace atelier {

bool outside_view(const glm::mat4& to_clip, const Box3& box, bool depth_from_zero) {
  if (box.empty()) return true;
  // The planes -w <= x, x <= w ... are linear in clip space, so a plane that has all corners of a box outside has all
  // of the box outside, wherever the eye is: no division by w, which may be zero or negative.
  std::array<bool, 6> all_outside;
  all_outside.fill(true);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 p(corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                       corner & 4 ? box.high.z : box.low.z, 1);
    const glm::dvec4 c = glm::dmat4(to_clip) * p;
    // What the shader computes in floats may differ in the sixth digit of the largest term: boxes that near pass.
    glm::dvec4 largest(0);
    for (int column = 0; column < 4; ++column) largest += glm::abs(glm::dvec4(to_clip[column]) * p[column]);
    const auto beyond = [&](int axis, double sign, double limit, double limit_size) {
      return sign * c[axis] - limit > 1e-5 * (largest[axis] + limit_size);
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
