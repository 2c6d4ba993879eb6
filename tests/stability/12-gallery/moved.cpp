// moved: flights and walks in one step and in a thousand, landings at once, from a picometre, at the very end and after
// hours, against the formulas of free fall in long double.
#include "stability/12-gallery/rows.hpp"

namespace atelier::stability {

using namespace gallery;

namespace {

constexpr double floor_level = visitor_half_size.y;  ///< of a centre whose box stands

/// A visitor, and what it does.
struct Movement {
  Visitor visitor;
  glm::dvec2 walking{0};
  double seconds = 0;

  Visitor after() const { return moved(visitor, walking, seconds); }
};

/// Where a movement leads, and the sizes of what is rounded on the way.
struct Arrival {
  Exact position{0}, velocity{0};
  long double way = 0;    ///< the metres of all that is summed, and what an error of the landing's time is worth
  long double speed = 0;  ///< the fastest
};

/// The time of the landing from the same equation, by the root that loses no digits.
long double landing_time(const Movement& m) {
  const auto up = static_cast<long double>(m.visitor.velocity.y);
  const long double above = static_cast<long double>(m.visitor.position.y) - floor_level;
  if (above <= 0 && up <= 0) return 0;
  const long double root = std::sqrt(up * up + 2 * static_cast<long double>(gravity) * above);
  return up > 0 ? (up + root) / static_cast<long double>(gravity) : 2 * above / (root - up);
}

Arrival exact_arrival(const Movement& m) {
  const long double g = gravity, seconds = m.seconds, landing = landing_time(m), flight = std::min(landing, seconds);
  const Exact from(m.visitor.position), v(m.visitor.velocity), walk(m.walking.x, 0, m.walking.y);
  Arrival a;
  a.position = from + flight * v - Exact(0, g * flight * flight / 2, 0);
  a.velocity = v - Exact(0, g * flight, 0);
  const long double fastest = largest_of(v) + largest_of(walk) + g * flight;
  if (seconds >= landing) {
    a.position += (seconds - flight) * walk;
    a.position.y = floor_level;
    a.velocity = walk;
  }
  a.speed = fastest;
  a.way = largest_of(from) + fastest * seconds + fastest * std::abs(v.y) / g;
  return a;
}

double position_error(const Movement& m) {
  const Arrival expected = exact_arrival(m);
  return largest_of(Exact(m.after().position) - expected.position) / double(expected.way);
}

double velocity_error(const Movement& m) {
  const Arrival expected = exact_arrival(m);
  return largest_of(Exact(m.after().velocity) - expected.velocity) / double(expected.speed);
}

/// Somewhere above the floor, with up to this speed along each axis, for up to so long.
Movement some_movement(Trial& t, double lowest, double highest, double speed, double longest) {
  Movement m{.visitor = {.position = 10.0 * t.direction(), .velocity = t.in_cube(speed)}};
  m.visitor.position.y = floor_level + t.size_between(lowest, highest);
  m.walking = {t.between(-2, 2), t.between(-2, 2)};
  m.seconds = t.between(0, longest);
  return m;
}

/// The same movement in `count` steps of equal length.
Visitor in_steps(const Movement& m, int count) {
  Visitor visitor = m.visitor;
  for (int i = 0; i < count; ++i) visitor = moved(visitor, m.walking, m.seconds / count);
  return visitor;
}

Values numbers_of(const Visitor& visitor) {
  return all_values(std::array{visitor.position, visitor.velocity});
}

void add_single_steps(Group& group) {
  struct Case {
    double lowest, highest, speed, longest;
    const char* words;
  };
  const Bound of_way{16 * double_unit, "of the way", "a square root, and sums of products of that size"},
      of_speed{16 * double_unit, "of the speed", "a product and a sum of that size"};
  for (const Case& c :
       {Case{0.01, 5, 5, 2, "jumps from up to 5 m"}, Case{1e-12, 1e-9, 5, 1, "from 1e-12 to 1e-9 m"},
        Case{1e-12, 1e-9, 1e-9, 1e-3, "from 1e-12 m, at up to 1e-9 m/s"}, Case{1e-3, 1, 1e3, 300, "at up to 1e3 m/s"},
        Case{1e-3, 1e6, 1e5, 1e4, "for up to 1e4 s"}, Case{0.01, 5, 5, 1e-9, "for up to 1e-9 s"}}) {
    const auto movement = [=](Trial& t) { return some_movement(t, c.lowest, c.highest, c.speed, c.longest); };
    group.close(fmt::format("4000 movements {}: position", c.words), of_way,
                [=] { return worst_of(4000, 2070, [=](Trial& t) { return position_error(movement(t)); }); });
    group.close(fmt::format("4000 movements {}: velocity", c.words), of_speed,
                [=] { return worst_of(4000, 2070, [=](Trial& t) { return velocity_error(movement(t)); }); });
  }
  group.close("4000 flights: energy", {32 * double_unit, "relative", "a height and a velocity with a few roundings"},
              [] {
                return worst_of(4000, 2071, [](Trial& t) {
                  Movement m = some_movement(t, 0.01, 100, 50, 1);
                  m.seconds *= double(landing_time(m));
                  const auto energy = [](const Visitor& v) {
                    return glm::dot(v.velocity, v.velocity) / 2 + gravity * v.position.y;
                  };
                  return std::abs(energy(m.after()) / energy(m.visitor) - 1);
                });
              });
}

void add_many_steps(Group& group) {
  for (const int count : {1, 2, 3, 10, 60, 1000}) {
    // Landings are at 1.4 m/s or more, so what a height is off makes the landing's time off by no more than that.
    const Bound rounded{16 * double_unit * (count + 1), "of the way", "each step rounds position and velocity"};
    group.close(fmt::format("200 jumps of up to 2 s in {} steps: position as in one", count), rounded, [=] {
      return worst_of(200, 2072, [=](Trial& t) {
        const Movement m = some_movement(t, 0.1, 5, 5, 2);
        const Arrival once = exact_arrival(m);
        return largest_of(Exact(in_steps(m, count).position) - once.position) / double(once.way);
      });
    });
    group.close(fmt::format("200 jumps of up to 2 s in {} steps: velocity as in one", count),
                {16 * double_unit * (count + 1), "of the speed", "each step rounds the velocity"}, [=] {
                  return worst_of(200, 2072, [=](Trial& t) {
                    const Movement m = some_movement(t, 0.1, 5, 5, 2);
                    const Arrival once = exact_arrival(m);
                    return largest_of(Exact(in_steps(m, count).velocity) - once.velocity) / double(once.speed);
                  });
                });
    group.close(fmt::format("200 walks of up to 1e4 s in {} steps: position", count), rounded, [=] {
      return worst_of(200, 2073, [=](Trial& t) {
        Movement m = some_movement(t, 0.1, 5, 5, 1e4);
        m.visitor.position.y = floor_level, m.visitor.velocity.y = 0;
        const Arrival once = exact_arrival(m);
        return largest_of(Exact(in_steps(m, count).position) - once.position) / double(once.way);
      });
    });
  }
}

void add_landings(Group& group) {
  // Which side of the landing the end is on, a rounding decides; the place is the same.
  group.close("1000 movements that end with the landing: position",
              {16 * double_unit, "of the way", "a square root, and sums of products of that size"}, [] {
                return worst_of(1000, 2074, [](Trial& t) {
                  Movement m = some_movement(t, 1e-9, 10, 10, 1);
                  m.seconds = double(landing_time(m));
                  return position_error(m);
                });
              });
  group.close("1000 movements that end 1e-6 s after the landing: height, where they walk",
              {16 * double_unit * 20, "m", "heights of up to 15 m are summed up"}, [] {
                return worst_of(1000, 2075, [](Trial& t) {
                  Movement m = some_movement(t, 1e-12, 10, 10, 1);
                  m.seconds = double(landing_time(m)) + 1e-6;
                  const Visitor after = m.after();
                  if (after.velocity != glm::dvec3(m.walking.x, 0, m.walking.y)) return double(infinite);
                  return std::abs(after.position.y - floor_level);
                });
              });
  group.equals(
      "1000 walks that start on the floor: other heights or velocities",
      [] {
        return Values{worst_of(1000, 2076, [](Trial& t) {
          Movement m = some_movement(t, 1, 2, 10, 1e4);
          m.visitor.position.y = floor_level;
          m.visitor.velocity.y = -std::abs(m.visitor.velocity.y);
          const Visitor after = m.after();
          return double(after.position.y != floor_level || after.velocity != glm::dvec3(m.walking.x, 0, m.walking.y));
        })};
      },
      {0});
  for (const double up : {1e-300, 1e-12, 1e-3, 1.0, 1e3})
    group.close(fmt::format("a jump from the floor at {:g} m/s: where it is after 1 s", up),
                {16 * double_unit, "of the way", "a square root, and sums of products of that size"}, [=] {
                  return position_error({.visitor = {.position = {0, floor_level, 0}, .velocity = {3, up, -2}},
                                         .walking = {-1, 2},
                                         .seconds = 1});
                });
}

void add_no_time(Group& group) {
  const auto row = [&](const char* words, double height, double up) {
    group.equals(std::string("0 seconds, ") + words,
                 [=] {
                   const Visitor before{.position = {1.3, floor_level + height, -7e5}, .velocity = {0.1, up, -1e3}};
                   return numbers_of(moved(before, {5, 6}, 0));
                 },
                 {1.3, floor_level + height, -7e5, 0.1, up, -1e3});
  };
  row("falling", 2.5, -3);
  row("rising", 2.5, 3);
  row("a picometre above the floor", 1e-12, -3);
  row("about to jump", 0, 1e-12);
  group.equals("0 seconds, on the floor: position",
               [] {
                 return values(moved({.position = {1.3, floor_level, -7e5}}, {5, 6}, 0).position);
               },
               {1.3, floor_level, -7e5});
}

}  // namespace

void add_moved_rows(Table& table) {
  Group group = table.of("moved");
  add_single_steps(group);
  add_many_steps(group);
  add_landings(group);
  add_no_time(group);
  group.equals("the room stays, in the air and on the floor",
               [] {
                 return Values{double(moved({.position = {0, 5, 0}, .room = largest_int}, {1, 1}, 0.1).room),
                               double(moved({.position = {0, floor_level, 0}, .room = hall}, {1, 1}, 0.1).room)};
               },
               {double(largest_int), double(hall)});
}

}  // namespace atelier::stability
