// meets: planes through corners and next to them, of all lengths, and boxes a million metres away.
#include "stability/12-gallery/rows.hpp"

namespace atelier::stability {

using namespace gallery;

namespace {

using Corners = std::array<glm::dvec3, 8>;

/// A box with these half extents, turned about y as the frame is.
Corners box_at(const glm::dmat4& frame, const glm::dvec3& extents) {
  Corners corners;
  for (std::size_t i = 0; i < 8; ++i)
    corners[i] = glm::dvec3(
        at(frame, {i & 1 ? extents.x : -extents.x, i & 2 ? extents.y : -extents.y, i & 4 ? extents.z : -extents.z}));
  return corners;
}

/// The least and the largest n.p of all corners.
std::pair<long double, long double> range_along(const Corners& corners, const Exact& n) {
  long double low = std::numeric_limits<long double>::infinity(), high = -low;
  for (const glm::dvec3& corner : corners) {
    const long double along = glm::dot(n, Exact(corner));
    low = std::min(low, along), high = std::max(high, along);
  }
  return {low, high};
}

/// Of 4000 boxes about planes, how many are judged wrongly; those that rounding may decide are left out, and less than
/// half of them may be.
double misjudged(double distance, double length) {
  int wrong = 0, judged = 0;
  for (int i = 0; i < 4000; ++i) {
    Trial t(2030, i);
    const Corners corners = box_at(upright_frame(t, distance),
                                   {t.size_between(0.01, 10), t.size_between(0.01, 10), t.size_between(0.01, 10)});
    const glm::dvec3 n = length * t.direction();
    const auto [low, high] = range_along(corners, Exact(n));
    const glm::dvec4 plane(n, -double(low + (high - low) * static_cast<long double>(t.between(-0.7, 1.7))));
    const long double noise = 16 * double_unit * length * (distance + 20), d = plane.w;
    if (std::min(std::abs(low + d), std::abs(high + d)) < noise) continue;
    wrong += meets(plane, corners) != (low + d <= 0 && high + d >= 0);
    ++judged;
  }
  return judged < 2000 ? double(infinite) : double(wrong);
}

/// A plane whose normal is of small whole numbers, so that nothing is rounded; none of them is 0.
glm::dvec3 whole_normal(Trial& t) {
  glm::dvec3 n(0);
  for (int i = 0; i < 3; ++i) n[i] = t.sign() * std::floor(t.between(1, 8));
  return n;
}

/// How many of 1000 answers are others for planes that are `beyond` (a dyadic number) before the first corner that
/// they come to, of normals times 2^power.
double others_at_corner(double beyond, int power, double size, bool expected) {
  return worst_of(1000, 2031, [=](Trial& t) {
    const Corners corners = box_at(quarter_frame(t, size), visitor_half_size);
    const glm::dvec3 n = whole_normal(t);
    const double d = -double(range_along(corners, Exact(n)).first) + beyond;
    const glm::dvec4 plane = std::ldexp(1.0, power) * glm::dvec4(n, d);
    return double(meets(plane, corners) != expected || meets(-plane, corners) != expected);
  });
}

}  // namespace

void add_meets_rows(Table& table) {
  Group group = table.of("meets");
  for (const double distance : {1.0, 1e3, million})
    for (const double length : {1e-100, 1.0, 1e100})
      group.equals(fmt::format("4000 boxes {:g} m away, normals of length {:g}: misjudged", distance, length),
                   [=] { return Values{misjudged(distance, length)}; }, {0});
  for (const double size : {16.0, million})
    for (const int power : {-900, 0, 900}) {
      const auto row = [&](const char* where, double beyond, bool expected) {
        group.equals(fmt::format("1000 planes {}, both ways round, up to {:g} m away, normals times 2^{}: others",
                                 where, size, power),
                     [=] { return Values{others_at_corner(beyond, power, size, expected)}; }, {0});
      };
      row("through one corner", 0, true);
      row("a hair into the box", -1.0 / 1024, true);
      row("a hair beside the box", 1.0 / 1024, false);
    }
  group.equals("along a face of the box, both ways round; a hair beside it; a hair into it",
               [] {
                 const Corners box = corners_of({million, 0, 0});
                 const double face = million + 0.25, hair = 1.0 / 1024;
                 return Values{double(meets({1, 0, 0, -face}, box)), double(meets({-1, 0, 0, face}, box)),
                               double(meets({1, 0, 0, -face - hair}, box)),
                               double(meets({-1, 0, 0, face - hair}, box))};
               },
               {1, 1, 0, 1});
  group.equals("a box without an extent: its point on the plane, before and behind it",
               [] {
                 Corners point;
                 point.fill({3, 4, 5});
                 return Values{double(meets({0, 0, 1, -5}, point)), double(meets({0, 0, 1, -4}, point)),
                               double(meets({0, 0, 1, -6}, point))};
               },
               {1, 0, 0});
}

}  // namespace atelier::stability
