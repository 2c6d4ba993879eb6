// touches: visitors at each of the six limits, just inside and just outside, and random ones, at frames turned by any
// angle, up to a million metres from the origin.
#include "stability/12-gallery/rows.hpp"

namespace atelier::stability {

using namespace gallery;

namespace {

/// The limits in the coordinates of the frame: the visitor touches where |x| <= most.x, |y| <= most.y and
/// 0 <= z <= most.z.
Exact limits(const glm::dmat4& frame, const glm::dvec2& half_size) {
  return {half_size.x, half_size.y + visitor_half_size.y, reach_along(axis(frame, 2))};
}

bool touches_exactly(const Exact& most, const Exact& local) {
  return std::abs(local.x) <= most.x && std::abs(local.y) <= most.y && local.z >= 0 && local.z <= most.z;
}

double others_than(const glm::dmat4& frame, const glm::dvec2& half_size, const Exact& local, bool expected) {
  return double(touches(frame, half_size, glm::dvec3(at(frame, local))) != expected);
}

/// Of 4000 visitors, how many are judged wrongly; those that rounding may decide are left out, and less than half of
/// them may be. At least a tenth of them touch the painting.
double misjudged(double distance, double half_size) {
  int wrong = 0, judged = 0, touching = 0;
  const glm::dvec2 half(half_size, half_size / 2);
  for (int i = 0; i < 4000; ++i) {
    Trial t(2050, i);
    const glm::dmat4 frame = upright_frame(t, distance);
    const Exact most = limits(frame, half);
    const Exact wanted(1.25 * most.x * t.between(-1, 1), 1.25 * most.y * t.between(-1, 1),
                       most.z * t.between(-0.25, 1.25));
    const glm::dvec3 position(at(frame, wanted));
    const Exact local = within(frame, Exact(position));
    const long double noise = 16 * double_unit * (distance + half_size + 2);
    const Exact shift(0, 0, noise), margin(noise, noise, 2 * noise);  // of z, both limits
    const bool certain = touches_exactly(most - margin, local - shift);
    if (certain != touches_exactly(most + margin, local + shift)) continue;
    wrong += touches(frame, half, position) != certain;
    ++judged;
    touching += certain;
  }
  return judged < 2000 || touching < 400 ? double(infinite) : double(wrong);
}

/// Rows for each limit: visitors who stand within it or beyond it by `share` of its size, and by `share` metres at the
/// painting's plane.
void add_limits(Group& group, double distance, double half_size, double share) {
  const glm::dvec2 half(half_size, half_size);
  const std::string where = fmt::format("{:g} m away, half a size of {:g} m, 1000 frames", distance, half_size);
  const auto row = [&](const char* limit, int coordinate, double sign) {
    for (const bool inside : {true, false})
      group.equals(fmt::format("{}: {:g} {} the {} limit: others", where, share, inside ? "within" : "beyond", limit),
                   [=] {
                     return Values{worst_of(1000, 2051, [=](Trial& t) {
                       const glm::dmat4 frame = upright_frame(t, distance);
                       const Exact most = limits(frame, half);
                       Exact local(0.9 * most.x * t.between(-1, 1), 0.9 * most.y * t.between(-1, 1),
                                   most.z * t.between(0.1, 0.9));
                       const double step = inside ? -share : share;
                       local[coordinate] = sign * most[coordinate] * (1 + static_cast<long double>(step));
                       if (coordinate == 2 && sign < 0) local.z = -step;
                       return others_than(frame, half, local, inside);
                     })};
                   },
                   {0});
  };
  row("right", 0, 1);
  row("left", 0, -1);
  row("upper", 1, 1);
  row("lower", 1, -1);
  row("farthest", 2, 1);
  row("nearest", 2, -1);
}

/// Quarter turns and dyadic places: nothing is rounded.
void add_exact_limits(Group& group) {
  const auto row = [&](const char* what, const Exact& local, bool expected) {
    group.equals(std::string(what) + ", quarter turns, 200 frames: others",
                 [=] {
                   return Values{worst_of(200, 2052, [=](Trial& t) {
                     return others_than(quarter_frame(t, 2048), {1, 1.25}, local, expected);
                   })};
                 },
                 {0});
  };
  const long double hair = 1.0L / 1024, high = 1.25L + visitor_half_size.y, far = visitor_half_size.z;
  row("on the right side plane", {1, 0, 0.125L}, true);
  row("1 mm beyond it", {1 + hair, 0, 0.125L}, false);
  row("on the left side plane", {-1, 0, 0.125L}, true);
  row("1 mm beyond it, on the left", {-1 - hair, 0, 0.125L}, false);
  row("the lower side at the painting's upper edge", {0, high, 0.125L}, true);
  row("1 mm above it", {0, high + hair, 0.125L}, false);
  row("the upper side at the painting's lower edge", {0, -high, 0.125L}, true);
  row("1 mm below it", {0, -high - hair, 0.125L}, false);
  row("the box ends on the plane", {0, 0, far}, true);
  row("the box ends 1 mm before the plane", {0, 0, far + hair}, false);
  row("the position on the plane", {0, 0, 0}, true);
  row("the position 1 mm behind the plane", {0, 0, -hair}, false);
  row("at two sides and at the edge, the box ends on the plane", {-1, high, far}, true);
  row("at two sides and at the edge, the position on the plane", {1, -high, 0}, true);
}

}  // namespace

void add_touches_rows(Table& table) {
  Group group = table.of("touches");
  for (const double distance : {1.0, million})
    for (const double half_size : {1e-3, 1.0, 1e3})
      group.equals(fmt::format("4000 visitors {:g} m away, half a size of {:g} m: misjudged", distance, half_size),
                   [=] { return Values{misjudged(distance, half_size)}; }, {0});
  for (const double half_size : {1e-3, 1.0, 1e3}) add_limits(group, 1, half_size, 1e-9);
  // There a few roundings of a coordinate are 1e-9 m.
  add_limits(group, million, 1, 1e-7);
  add_exact_limits(group);
}

}  // namespace atelier::stability
