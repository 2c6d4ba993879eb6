#include "oracle/beam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace atelier::oracle {

namespace {

// What is left out must be missed by every ray as it is computed, not only on paper. Both are shares of the largest
// length at hand.
constexpr double aside = 1e-9;      ///< far above what rounding and a gap of 1e-11 move a ray; costs nothing
constexpr double rounding = 1e-14;  ///< of a product of three lengths, some dozens of roundings; far below a gap

double size_of(const glm::dvec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

}  // namespace

Beam::Beam(const glm::dvec3& apex, const Window& window, const glm::dvec2& low, const glm::dvec2& high, double gap)
    : apex_(apex), endless_(window.endless), gap_(gap), reach_(size_of(apex) + size_of(window.middle)) {
  const auto& [right, up, ahead] = window.frame;
  for (int corner = 0; corner < 4; ++corner)
    ends_[std::size_t(corner)] =
        window.middle + (corner & 1 ? high.x : low.x) * right + (corner & 2 ? high.y : low.y) * up;
  for (const glm::dvec3& end : ends_) reach_ = std::max(reach_, size_of(apex) + size_of(end));

  // In the frame, from the apex: a ray is t (x, y, depth), with x and y between the window's sides and one depth for
  // all. At distance z along the axis, t = z / depth, so that x <= x_high t is depth x - x_high z <= 0, and so on.
  const double along = glm::dot(window.middle, ahead), depth = std::abs(along);
  const glm::dvec3 away = along < 0 ? -ahead : ahead;
  const double x = glm::dot(window.middle, right), y = glm::dot(window.middle, up);
  half_spaces_ = {{{unit_or_zero((x + low.x) * away - depth * right)},
                   {unit_or_zero(depth * right - (x + high.x) * away)},
                   {unit_or_zero((y + low.y) * away - depth * up)},
                   {unit_or_zero(depth * up - (y + high.y) * away)},
                   {-away},
                   {away, window.endless ? std::numeric_limits<double>::infinity() : depth}}};
}

bool Beam::misses(const Box3& box) const {
  const glm::dvec3 middle = (box.low + box.high) * 0.5 - apex_, half = (box.high - box.low) * 0.5;
  const double slack = aside * (reach_ + size_of(middle) + size_of(half));
  return std::ranges::any_of(half_spaces_, [&](const HalfSpace& space) {
    return glm::dot(space.normal, middle) - glm::dot(glm::abs(space.normal), half) > space.most + slack;
  });
}

bool Beam::misses(std::span<const glm::dvec3> points) const {
  return std::ranges::any_of(half_spaces_, [&](const HalfSpace& space) {
    return std::ranges::all_of(points, [&](const glm::dvec3& point) {
      const glm::dvec3 from_apex = point - apex_;
      return glm::dot(space.normal, from_apex) > space.most + aside * (reach_ + size_of(from_apex));
    });
  });
}

bool Beam::misses_plane(const glm::dvec3& point, const glm::dvec3& side, const glm::dvec3& other_side) const {
  glm::dvec3 normal = glm::cross(side, other_side);
  const glm::dvec3 from_point = apex_ - point;
  double above = glm::dot(normal, from_point);
  if (above < 0) above = -above, normal = -normal;
  // The apex is where it is; of the ends, rays may come as near to the plane as they may run beside the window.
  const double area = size_of(side) * size_of(other_side);
  const double slack = rounding * area * (reach_ + size_of(from_point));
  const double slack_at_end = slack + 4 * gap_ * area;
  if (above <= slack) return false;
  return std::ranges::all_of(ends_, [&](const glm::dvec3& end) {
    const double climb = glm::dot(normal, end);
    return endless_ ? climb > slack_at_end : above + climb > slack_at_end;
  });
}

}  // namespace atelier::oracle
