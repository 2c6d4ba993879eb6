// held: polygons of 3 to 256 walls, rooms that are hardly larger than the box, sharp corners, and positions from inside
// to a kilometre outside, against a search among all sides and corners of where the box may stand.
#include <optional>

#include "stability/12-gallery/rows.hpp"

namespace atelier::stability {

using namespace gallery;

namespace {

using Walls = std::vector<glm::dvec4>;
using Point = glm::vec<2, long double>;

constexpr double most_behind = 1e-9;  ///< metres, in the contract

/// How far a corner of the box is behind a wall; below 0 where it is before it.
long double behind(const glm::dvec4& wall, const Exact& position) {
  const Exact n{glm::dvec3(wall)};
  return reach_along(-n) - glm::dot(n, position) - static_cast<long double>(wall.w);
}

double most_behind_of(const Walls& walls, const Exact& position) {
  long double most = -std::numeric_limits<long double>::infinity();
  for (const glm::dvec4& wall : walls) most = std::max(most, behind(wall, position));
  return double(most);
}

/// An upright wall that faces this direction, this far from a centre on its front.
glm::dvec4 wall_facing(double angle, const glm::dvec3& centre, double distance) {
  const Exact n(glm::dvec3(std::cos(angle), 0, std::sin(angle)));
  return {glm::dvec3(n), double(distance - glm::dot(n, Exact(centre)))};
}

/// A convex room about a centre that lies `least` metres or more from where a wall would hold the box, and a factor of
/// up to 2 more.
Walls some_room(Trial& t, int count, const glm::dvec3& centre, double least) {
  Walls walls;
  const double turn = t.between(0, 2 * std::numbers::pi);
  for (int i = 0; i < count; ++i) {
    const double angle = turn + 2 * std::numbers::pi * (i + t.between(-0.2, 0.2)) / count;
    const auto reach = double(reach_along(Exact(std::cos(angle), 0, std::sin(angle))));
    walls.push_back(wall_facing(angle, centre, reach + least * t.between(1, 2)));
  }
  return walls;
}

/// Two walls with this angle between them. Where the box may stand begins at the centre.
Walls some_corner(Trial& t, double degrees, const glm::dvec3& centre) {
  Walls walls;
  const double middle = t.between(0, 2 * std::numbers::pi), half = degrees * std::numbers::pi / 360;
  for (const double angle : {middle - std::numbers::pi / 2 + half, middle + std::numbers::pi / 2 - half})
    walls.push_back(wall_facing(angle, centre, double(reach_along(Exact(std::cos(angle), 0, std::sin(angle))))));
  return walls;
}

/// The distance from a position to the nearest one at which upright walls leave the box alone: that is the position
/// itself, or on the line of a wall, or where two of these lines meet.
double nearest_distance(const Walls& walls, const glm::dvec3& position) {
  const auto allowed = [&](const Point& p) {
    return std::ranges::all_of(walls, [&](const glm::dvec4& wall) {
      return behind(wall, {p.x, static_cast<long double>(position.y), p.y}) <= 1e-12L;
    });
  };
  const Point from(position.x, position.z);
  if (allowed(from)) return 0;
  long double best = std::numeric_limits<long double>::infinity();
  const auto consider = [&](const Point& p) {
    if (const long double there = glm::length(p - from); there < best && allowed(p)) best = there;
  };
  struct Line {
    Point n;
    long double d;  ///< n.p = d
  };
  std::vector<Line> lines;
  for (const glm::dvec4& wall : walls) {
    const Exact n{glm::dvec3(wall)};
    lines.push_back({{n.x, n.z}, reach_along(-n) - static_cast<long double>(wall.w)});
  }
  for (const Line& a : lines) consider(from + (a.d - glm::dot(a.n, from)) * a.n);
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Line &a = lines[i], &b = lines[k];
      const long double determinant = a.n.x * b.n.y - a.n.y * b.n.x;
      if (std::abs(determinant) < 1e-9L) continue;
      consider(Point(a.d * b.n.y - b.d * a.n.y, a.n.x * b.d - b.n.x * a.d) / determinant);
    }
  return double(best);
}

/// How many times as far as the nearest position the one is where the walls hold the box. Positions nearer than a
/// thousand times what a corner may be behind do not count.
double times_as_far(const Walls& walls, const glm::dvec3& position) {
  const double nearest = nearest_distance(walls, position);
  if (nearest < 1000 * most_behind) return 0;
  return glm::length(held(walls, position) - position) / nearest;
}

/// A room, and a position somewhere about it.
struct Stand {
  Walls walls;
  glm::dvec3 position;
};

void add_stands(Group& group, const std::string& words, int count, const std::function<Stand(Trial&)>& stand) {
  group.close(fmt::format("{} {}: how far a corner of the box is behind a wall", count, words),
              {most_behind, "m", "the contract's own limit"}, [=] {
                return worst_of(count, 2080, [=](Trial& t) {
                  const Stand s = stand(t);
                  return std::max(most_behind_of(s.walls, Exact(held(s.walls, s.position))), 0.0);
                });
              });
  group.close(fmt::format("{} {}: how far it moves", count, words),
              {4, "of the nearest", "the contract allows four times the distance"}, [=] {
                return worst_of(count, 2080, [=](Trial& t) {
                  const Stand s = stand(t);
                  return times_as_far(s.walls, s.position);
                });
              });
  group.equals(fmt::format("{} {}: heights that change", count, words),
               [=] {
                 return Values{worst_of(count, 2080, [=](Trial& t) {
                   const Stand s = stand(t);
                   return double(held(s.walls, s.position).y != s.position.y);
                 })};
               },
               {0});
}

void add_rooms(Group& group) {
  const glm::dvec3 centre(30, 0.875, -512);
  for (const int count : {3, 4, 5, 16, 256})
    for (const double outside : {1.0, 1e3}) {
      const int trials = count > 16 ? 20 : 200;
      const auto from = [=](Trial& t) {
        const double angle = t.between(0, 2 * std::numbers::pi);
        return centre + outside * t.between(0, 1) * glm::dvec3(std::cos(angle), 0, std::sin(angle));
      };
      add_stands(group, fmt::format("rooms of {} walls, up to {:g} m from the centre", count, outside), trials,
                 [=](Trial& t) {
                   return Stand{some_room(t, count, centre, 0.5), from(t)};
                 });
      add_stands(group, fmt::format("rooms of {} walls with 1e-6 m to spare, up to {:g} m away", count, outside),
                 trials, [=](Trial& t) {
                   return Stand{some_room(t, count, centre, 1e-6), from(t)};
                 });
    }
  for (const double degrees : {10.0, 30.0, 90.0, 170.0})
    for (const double outside : {1.0, 1e3})
      add_stands(group, fmt::format("corners of {:g} degrees, up to {:g} m away", degrees, outside), 200,
                 [=](Trial& t) {
                   const double angle = t.between(0, 2 * std::numbers::pi);
                   const glm::dvec3 way(std::cos(angle), 0, std::sin(angle));
                   return Stand{some_corner(t, degrees, centre), centre + outside * t.between(0, 1) * way};
                 });
}

/// Behind one wall by up to so much, and before all others by a centimetre or more.
std::optional<Stand> some_slide(Trial& t, int count, double most) {
  const glm::dvec3 centre(30, 0.875, -512);
  Stand s{some_room(t, count, centre, 0.5), {}};
  const glm::dvec4 wall = s.walls[std::size_t(t.between(0, count))];
  const glm::dvec3 n(wall);
  const double depth = most * t.between(0, 1) - double(behind(wall, Exact(centre))), aside = t.between(-0.1, 0.1);
  s.position = centre - depth * n + aside * glm::dvec3(n.z, 0, -n.x);
  const auto in_the_way = std::ranges::count_if(
      s.walls, [&](const glm::dvec4& other) { return behind(other, Exact(s.position)) > -0.01L; });
  if (in_the_way != 1) return {};
  return s;
}

/// How far from the place straight before the wall; infinite where hardly any trial tells.
double slide_error(int count, double most) {
  double worst = 0;
  int tried = 0;
  for (int i = 0; i < 1000; ++i) {
    Trial t(2081, i);
    const std::optional<Stand> s = some_slide(t, count, most);
    if (!s) continue;
    Exact expected(s->position);
    for (const glm::dvec4& wall : s->walls)
      if (const long double by = behind(wall, Exact(s->position)); by > 0) expected += by * Exact(glm::dvec3(wall));
    const double here = largest_of(Exact(held(s->walls, s->position)) - expected);
    if (!(here <= worst)) worst = std::isnan(here) ? double(infinite) : here;
    ++tried;
  }
  return tried < 50 ? double(infinite) : worst;
}

/// A room along the axes of the world, floor and ceiling among its walls, from `low` to `high`.
Walls box_room(const glm::dvec3& low, const glm::dvec3& high) {
  Walls walls;
  for (int i = 0; i < 3; ++i) {
    glm::dvec3 n(0);
    n[i] = 1;
    walls.emplace_back(n, -low[i]);
    walls.emplace_back(-n, high[i]);
  }
  return walls;
}

void add_far_slides(Group& group) {
  for (const double outside : {1e-6, 1.0, 1e3})
    group.close(fmt::format("1000 positions up to {:g} m outside of one side of a box: straight to it", outside),
                {2 * most_behind, "m", "the box may end as far behind the wall; roundings of 1000 m are 1e-13 m"}, [=] {
                  return worst_of(1000, 2084, [=](Trial& t) {
                    const glm::dvec3 low(-3, 0, -500), high(2, 4, -490);
                    const glm::dvec3 first = low + visitor_half_size, last = high - visitor_half_size;
                    glm::dvec3 expected(0);
                    for (int i = 0; i < 3; ++i) expected[i] = t.between(first[i], last[i]);
                    glm::dvec3 position = expected;
                    const int side = int(t.between(0, 3));
                    const bool beyond = t.sign() > 0;
                    expected[side] = beyond ? last[side] : first[side];
                    position[side] = expected[side] + (beyond ? outside : -outside) * t.between(0, 1);
                    return largest_of(Exact(held(box_room(low, high), position)) - Exact(expected));
                  });
                });
}

void add_inside(Group& group) {
  for (const double distance : {1.0, 1e3, million})
    group.equals(
        fmt::format("1000 positions inside, rooms {:g} m away: those that do not stay to the last bit", distance),
        [=] {
          return Values{worst_of(1000, 2082, [=](Trial& t) {
            const glm::dvec3 position = distance * t.direction();
            const Walls walls = some_room(t, int(t.between(3, 20)), position, 1e-6);
            return double(held(walls, position) != position);
          })};
        },
        {0});
  group.equals("a box that touches two walls, dyadic places: to the last bit",
               [] {
                 return values(held(box_room({-1024, 0, 2}, {8, 4, 9}), {8 - 0.25, 0.875, 2.25}));
               },
               {7.75, 0.875, 2.25});
  group.equals("no walls", [] { return values(held({}, {1e300, -1e-300, 0.1})); }, {1e300, -1e-300, 0.1});
  group.equals("a room as large as the box, from its middle",
               [] {
                 const glm::dvec3 middle(16, 3, -4);
                 return values(held(box_room(middle - visitor_half_size, middle + visitor_half_size), middle));
               },
               {16, 3, -4});
  group.close("a room as large as the box, 1000 positions up to 1e3 m away: the distance from its middle",
              {2 * most_behind, "m", "the contract's own limit, along each axis"}, [] {
                return worst_of(1000, 2083, [](Trial& t) {
                  const glm::dvec3 middle(16, 3, -4);
                  return largest_of(Exact(held(box_room(middle - visitor_half_size, middle + visitor_half_size),
                                               middle + t.in_cube(1e3))) -
                                    Exact(middle));
                });
              });
}

}  // namespace

void add_held_rows(Table& table) {
  Group group = table.of("held");
  add_rooms(group);
  for (const int count : {3, 4, 5, 16})
    for (const double most : {1e-6, 0.1})
      group.close(
          fmt::format("rooms of {} walls, up to {:g} m behind one of them: straight along its normal", count, most),
          {2 * most_behind, "m", "the box may end as far behind the wall; roundings of 1000 m are 1e-13 m"},
          [=] { return slide_error(count, most); });
  add_far_slides(group);
  add_inside(group);
}

}  // namespace atelier::stability
