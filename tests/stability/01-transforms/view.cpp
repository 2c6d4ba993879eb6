// look_at: cameras that look along up, at themselves, from far away.
#include "stability/01-transforms/exact.hpp"
#include "stability/01-transforms/rows.hpp"

namespace atelier::stability {

using transforms::look_at;

namespace {

/// The largest error of an axis of the camera, held against exact::in_view on the directions x, y and z.
double axes_error(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up) {
  const glm::mat4 view = look_at(eye, target, up);
  double worst = 0;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 along(0);
    along[axis] = 1;
    const glm::dvec3 expected = exact::in_view({0, 0, 0}, glm::dvec3(target) - glm::dvec3(eye), up, along);
    worst = std::max(worst, difference(values(glm::dvec3(view[axis])), values(expected)));
  }
  return worst;
}

/// Where the eye comes to lie, which should be the origin, as a share of its distance from the world's.
double eye_error(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up) {
  const glm::dvec3 at(glm::dmat4(look_at(eye, target, up)) * glm::dvec4(eye, 1));
  return glm::length(at) / glm::length(glm::dvec3(eye));
}

const Bound axis_bound{8 * rounding_unit, "absolute",
                       "a unit axis comes of a difference, a cross product and two normalisations"};
const Bound eye_bound{8 * rounding_unit, "of the eye's distance", "three products of an axis and the eye, summed"};

/// Up along or against the view, where the contract names the axis that stands in.
void add_parallel_rows(Group& group) {
  struct Case {
    const char* words;
    glm::vec3 target, up, stand_in;
  };
  const Case cases[] = {
      {"looking straight down along up", {0, -1, 0}, {0, 1, 0}, {1, 0, 0}},
      {"looking straight up along up", {0, 3, 0}, {0, 2, 0}, {1, 0, 0}},
      {"up along x, looking along x: y stands in", {5, 0, 0}, {1, 0, 0}, {0, 1, 0}},
      {"all components alike: x stands in", {1, 1, 1}, {-2, -2, -2}, {1, 0, 0}},
      {"z smallest: z stands in", {-3, 4, 0.5f}, {-6, 8, 1}, {0, 0, 1}},
      {"no up at all", {0, 0, -4}, {0, 0, 0}, {1, 0, 0}},
      {"up a millionth of a millionth off the view", {0, -1, 0}, {1e-12f, 1, 0}, {1, 0, 0}},
  };
  for (const Case& c : cases)
    group.close(c.words, axis_bound, [c] {
      // The stand-in is an up like any other: the same camera asked for with it.
      return difference(values(look_at({0, 0, 0}, c.target, c.up)), values(look_at({0, 0, 0}, c.target, c.stand_in)));
    });
  for (const float angle : {1e-2f, 1e-4f, 1e-5f})
    group.close(fmt::format("up {:.0e} rad off the view: the axes", angle),
                {4 * rounding_unit / angle, "absolute",
                 "the horizon is the direction of a difference that is only this angle long, and so knows its own "
                 "direction to a rounding over the angle"},
                [=] {
                  return axes_error({1, 2, 3}, {1, -5, 3}, {angle, 1, 0.5f * angle});
                });
}

void add_size_rows(Group& group) {
  group.equals(
      "eye = target: along -z",
      [] {
        return values(look_at({0, 0, 0}, {0, 0, 0}, {0, 1, 0}));
      },
      values(glm::mat4(1)));
  group.equals(
      "eye = target, a million metres away",
      [] {
        return values(glm::mat3(look_at(glm::vec3(1e6f), glm::vec3(1e6f), {0, 1, 0})));
      },
      values(glm::mat3(1)));
  for (const float size : {1e-17f, 1e-9f, 1e9f, 1e18f})
    group.close(fmt::format("up {:.0e} long", size), axis_bound, [=] {
      return axes_error({1, 2, 3}, {4, 1, -2}, size * glm::vec3(0.2f, 1, 0.1f));
    });
  for (const float distance : {1e-17f, 1e-6f, 1e10f, 1e18f})
    group.close(fmt::format("the target {:.0e} m away", distance), axis_bound, [=] {
      return axes_error({0, 0, 0}, distance * glm::vec3(0.6f, -0.5f, -0.7f), {0, 1, 0});
    });
  for (const float offset : {1e6f, 1e9f})
    group.close(fmt::format("the eye {:.0e} m from the origin", offset), eye_bound, [=] {
      return eye_error(glm::vec3(offset, 2, -offset), glm::vec3(offset, 0, 0), {0, 1, 0});
    });
  group.nan("an eye of NaN", [] { return values(look_at({not_a_number, 0, 0}, {0, 0, 0}, {0, 1, 0})); });
}

}  // namespace

void add_view_rows(Table& table) {
  Group group = table.of("look_at");
  add_parallel_rows(group);
  add_size_rows(group);
  group.close("3000 random cameras, up at least a tenth of a radian off: the axes",
              {60 * rounding_unit, "absolute",
               "as for one camera, 6 roundings, over the sine of the angle between up and view, which is 0.1 at least"},
              [] {
                return worst_of(3000, 20, [](Trial& t) {
                  const glm::vec3 eye(t.in_cube(100)), target(t.in_cube(100));
                  const glm::vec3 up(t.size_between(1e-9, 1e9) * t.direction());
                  const glm::dvec3 ahead = glm::normalize(glm::dvec3(target) - glm::dvec3(eye));
                  if (glm::length(glm::cross(glm::normalize(glm::dvec3(up)), ahead)) < 0.1) return 0.0;
                  return axes_error(eye, target, up);
                });
              });
  group.close(
      "3000 random cameras and ups: rigid",
      {16 * rounding_unit, "absolute", "three products of entries that each may be 4 roundings off, summed"}, [] {
        return worst_of(3000, 21,
                        [](Trial& t) { return not_rigid(look_at(t.in_cube(100), t.in_cube(100), t.direction())); });
      });
  group.close("300 random ups within a hundredth of the view: rigid, times the angle between them",
              {4 * rounding_unit, "times the sine of the angle",
               "up x view is as long as that sine, and its rounding is not square to the view"},
              [] {
                return worst_of(300, 22, [](Trial& t) {
                  const glm::dvec3 ahead = t.direction();
                  const glm::vec3 up(ahead + t.size_between(1e-5, 1e-2) * t.direction());
                  const double sine = glm::length(glm::cross(glm::normalize(glm::dvec3(up)), ahead));
                  return not_rigid(look_at({0, 0, 0}, ahead, up)) * sine;
                });
              });
}

}  // namespace atelier::stability
