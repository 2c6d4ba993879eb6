#include "oracle/beam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace atelier::oracle {

namespace {

// Culling must be conservative for rays as they are computed, including rounding. Both values are relative to the
// lengths involved.
constexpr double aside = 1e-9;      ///< margin far above rounding errors; widening beams by this costs nothing
constexpr double rounding = 4e-15;  ///< a few dozen rounding errors; far below a ray's offset from its own surface

double size_of(const glm::dvec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

}  // namespace

Beam::Beam(const glm::dvec3& apex, const Window& window, const glm::dvec2& low, const glm::dvec2& high, double bend)
    : apex_(apex), endless_(window.endless), bend_(bend) {
  const auto& [right, up, ahead] = window.frame;
  for (int corner = 0; corner < 4; ++corner)
    ends_[std::size_t(corner)] =
        window.middle + (corner & 1 ? high.x : low.x) * right + (corner & 2 ? high.y : low.y) * up;
  for (const glm::dvec3& end : ends_) reach_ = std::max(reach_, size_of(end));

  // In the frame, relative to the apex: a ray is t (x, y, depth), with x and y between the window's sides and the same
  // depth for all rays. At distance z along the axis, t = z / depth, so x <= x_high t is depth x - x_high z <= 0, and
  // so on.
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
  const double slack = aside * (reach_ + size_of(middle) + size_of(half)) + 4 * bend_;
  return std::ranges::any_of(half_spaces_, [&](const HalfSpace& space) {
    return glm::dot(space.normal, middle) - glm::dot(glm::abs(space.normal), half) > space.most + slack;
  });
}

bool Beam::misses(std::span<const glm::dvec3> corners) const {
  return all_outside_one_half_space(corners) || stays_on_one_side(corners) || passes_an_edge(corners);
}

bool Beam::all_outside_one_half_space(std::span<const glm::dvec3> corners) const {
  return std::ranges::any_of(half_spaces_, [&](const HalfSpace& space) {
    return std::ranges::all_of(corners, [&](const glm::dvec3& corner) {
      const glm::dvec3 from_apex = corner - apex_;
      return glm::dot(space.normal, from_apex) > space.most + aside * (reach_ + size_of(from_apex)) + 4 * bend_;
    });
  });
}

/// Whether the beam never crosses the face's plane. True for the surface at which its rays start.
bool Beam::stays_on_one_side(std::span<const glm::dvec3> corners) const {
  const glm::dvec3 side = corners[1] - corners.front(), other_side = corners.back() - corners.front();
  const glm::dvec3 from_corner = apex_ - corners.front();
  glm::dvec3 normal = glm::cross(side, other_side);
  double above = glm::dot(normal, from_corner);
  if (above < 0) above = -above, normal = -normal;
  const double area = size_of(side) * size_of(other_side);
  const double slack = rounding * area * (reach_ + size_of(from_corner));
  if (above <= slack) return false;
  // The apex is exact; the ends of rays may deviate from the window's.
  return std::ranges::all_of(ends_, [&](const glm::dvec3& end) {
    return (endless_ ? 0 : above) + glm::dot(normal, end) > slack + 4 * bend_ * area;
  });
}

/// Whether, seen from the apex, the whole window lies outside the line through one of the face's edges. Together with
/// the window's edges (the half-spaces) this is a separating-axis test: both are convex.
bool Beam::passes_an_edge(std::span<const glm::dvec3> corners) const {
  const glm::dvec3 first = corners[0] - apex_, second = corners[1] - apex_, last = corners.back() - apex_;
  const double around = size_of(first) + size_of(second) + size_of(last);
  const double volume = glm::dot(glm::cross(first, second), last);  // its sign is the winding, seen from the apex
  if (std::abs(volume) <= rounding * around * around * around) return false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a = corners[i] - apex_, b = corners[(i + 1) % corners.size()] - apex_;
    const glm::dvec3 inwards = volume < 0 ? glm::cross(b, a) : glm::cross(a, b);
    const double sizes = size_of(a) + size_of(b);
    const bool beyond = std::ranges::all_of(ends_, [&](const glm::dvec3& end) {
      return glm::dot(inwards, end) <
             -sizes * (rounding * sizes * size_of(end) + 4 * bend_ * std::min(size_of(a), size_of(b)));
    });
    if (beyond) return true;
  }
  return false;
}

}  // namespace atelier::oracle
