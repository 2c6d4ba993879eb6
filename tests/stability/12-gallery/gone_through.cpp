// gone_through: where visitors come out who have gone through paintings of any turn, near and a million metres away,
// and how far before the exit their boxes end.
#include "07-stencil-portals/stencil_portals.hpp"
#include "stability/12-gallery/rows.hpp"

namespace atelier::stability {

using namespace gallery;

namespace {

/// Someone at a painting.
struct Passage {
  glm::dmat4 entry{1}, exit{1};
  Visitor visitor;
  double clearance = 0, speed = 0;

  Visitor after() const { return gone_through(visitor, entry, exit, 3, clearance, speed); }
};

/// The visitor stands at a place of the entry (at `before` and up to a metre more before its plane), in the air or not.
Passage some_passage(Trial& t, double distance, double clearance, double before) {
  Passage p{.entry = upright_frame(t, distance), .exit = upright_frame(t, distance), .clearance = clearance};
  p.visitor.position = glm::dvec3(at(p.entry, {t.between(-1, 1), t.between(-1, 1), before + t.between(0, 1)}));
  p.visitor.velocity = t.in_cube(10);
  p.speed = t.between(0, 10);
  return p;
}

/// The least height of all corners of a box above the exit's plane.
long double nearest_corner(const Passage& p, const Exact& position) {
  return within(p.exit, position).z - reach_along(axis(p.exit, 2));
}

/// How far it must still move once it has been carried.
long double push(const Passage& p) {
  return std::max(p.clearance - nearest_corner(p, through(p.entry, p.exit, Exact(p.visitor.position))), 0.0L);
}

double position_error(const Passage& p) {
  const Exact expected = through(p.entry, p.exit, Exact(p.visitor.position)) + push(p) * axis(p.exit, 2);
  return largest_of(Exact(p.after().position) - expected);
}

/// How far the nearest corner is from where it should end.
double clearance_error(const Passage& p) {
  double low = infinite;
  for (const glm::dvec3& corner : corners_of(p.after().position))
    low = std::min(low, double(within(p.exit, Exact(corner)).z));
  return std::abs(low - p.clearance);
}

constexpr const char* through_matrices = "coordinates of that size through two matrices, and a move along an axis";

void add_velocity_rows(Group& group) {
  for (const double speed : {1e-9, 2.0, 1e3})
    group.close(fmt::format("a jump of {:g} m/s, 1000 frames: velocity", speed),
                {4 * double_unit * speed, "m/s", "two products of the speed and a unit vector"}, [=] {
                  return worst_of(1000, 2064, [=](Trial& t) {
                    Passage p = some_passage(t, 10, 0.05, 0);
                    p.speed = speed;
                    const long double exact = speed;
                    const Exact expected = exact * axis(p.exit, 2) + Exact(0, speed, 0);
                    return largest_of(Exact(p.after().velocity) - expected);
                  });
                });
  group.equals("a jump of 0 m/s, 1000 frames: velocity",
               [] {
                 return Values{worst_of(1000, 2066, [](Trial& t) {
                   Passage p = some_passage(t, 10, 0.05, 0);
                   p.speed = 0;
                   return largest_of(Exact(p.after().velocity));
                 })};
               },
               {0});
  for (const int room : {hall, 0, 5, largest_int, least_int})
    group.equals(fmt::format("into room {}", room),
                 [=] {
                   const glm::dmat4 frame(1);
                   return Values{double(gone_through({.room = 4}, frame, frame, room, 0.05, 1).room)};
                 },
                 {double(room)});
}

}  // namespace

void add_through_rows(Table& table) {
  Group group = table.of("gone_through");
  for (const double distance : {1.0, 1e3, million})
    for (const double clearance : {0.0, 1e-9, 0.05, 100.0})
      group.close(fmt::format("1000 frames {:g} m away, a clearance of {:g} m: position", distance, clearance),
                  metres(2 * (distance + clearance + 10), through_matrices), [=] {
                    return worst_of(1000, 2060,
                                    [=](Trial& t) { return position_error(some_passage(t, distance, clearance, 0)); });
                  });
  for (const double distance : {1.0, 1e3})
    for (const double clearance : {0.0, 1e-9, 0.05, 100.0})
      group.close(
          fmt::format("1000 frames {:g} m away: the nearest corner is {:g} m before the exit", distance, clearance),
          {1e-9, "m", "a visitor may not notice; roundings of a kilometre are 1e-13 m"}, [=] {
            return worst_of(1000, 2061,
                            [=](Trial& t) { return clearance_error(some_passage(t, distance, clearance, 0)); });
          });
  for (const double distance : {1.0, million}) {
    // From behind the entry, whoever comes out is before the exit.
    group.close(fmt::format("1000 frames {:g} m away, clear already: where portal_passage leads", distance),
                metres(2 * (distance + 10), through_matrices), [=] {
                  return worst_of(1000, 2062, [=](Trial& t) {
                    const Passage p = some_passage(t, distance, 0.05, -3);
                    const glm::dmat4 passage = stencil_portals::portal_passage(p.entry, p.exit);
                    return largest_of(Exact(p.after().position) -
                                      Exact(glm::dvec3(passage * glm::dvec4(p.visitor.position, 1))));
                  });
                });
    group.close(fmt::format("1000 frames {:g} m away: from portal_passage straight along the exit's +z", distance),
                metres(2 * (distance + 10), through_matrices), [=] {
                  return worst_of(1000, 2063, [=](Trial& t) {
                    const Passage p = some_passage(t, distance, 0.05, 0);
                    const glm::dmat4 passage = stencil_portals::portal_passage(p.entry, p.exit);
                    const Exact moved =
                        Exact(p.after().position) - Exact(glm::dvec3(passage * glm::dvec4(p.visitor.position, 1)));
                    return std::max({std::abs(double(glm::dot(moved, axis(p.exit, 0)))), std::abs(double(moved.y)),
                                     -double(glm::dot(moved, axis(p.exit, 2)))});
                  });
                });
  }
  group.equals("quarter turns and dyadic places up to 1024 m along each axis: the error of positions and clearances",
               [] {
                 return Values{worst_of(1000, 2065, [](Trial& t) {
                   Passage p{.entry = quarter_frame(t, 1024), .exit = quarter_frame(t, 1024), .clearance = 0.0625};
                   p.visitor.position = dyadic_place(t, 1024);
                   const double off = position_error(p);
                   return push(p) > 0 ? std::max(off, clearance_error(p)) : off;
                 })};
               },
               {0});
  add_velocity_rows(group);
}

}  // namespace atelier::stability
