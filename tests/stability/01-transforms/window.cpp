// window_position and relative_to_eye.
#include "stability/01-transforms/rows.hpp"

namespace atelier::stability {

using transforms::relative_to_eye;
using transforms::window_position;

namespace {

/// In pixels, and for the depth in units of the depth; `clip` and `viewport` are taken as exact.
double window_error(const glm::vec4& clip, const glm::vec4& viewport) {
  const glm::dvec3 device = glm::dvec3(clip) / double(clip.w);
  const glm::dvec3 expected(viewport.x + (device.x + 1) / 2 * viewport.z, viewport.y + (device.y + 1) / 2 * viewport.w,
                            (device.z + 1) / 2);
  return difference(values(window_position(clip, viewport)), values(expected));
}

void add_window_position_rows(Table& table) {
  Group group = table.of("window_position");
  const Bound pixel{16384 * 3 * rounding_unit, "pixels",
                    "a quotient, a sum and a product, of up to 16384 pixels, the largest picture"};
  const glm::vec4 screen(0, 0, 16384, 16384);
  for (const float w : {1e-30f, 1e-6f, 1e6f, 1e30f})
    group.close(fmt::format("w = {:.0e}", w), pixel,
                [=] { return window_error(w * glm::vec4(0.3f, -0.7f, 0.9f, 1), screen); });
  for (const float side : {-1.0f, 1.0f})
    group.close(fmt::format("the corner at {:g}", side), pixel, [=] {
      return window_error({side, side, side, 1}, screen);
    });
  group.close("a viewport of 1x1", {3 * rounding_unit, "pixels", "a quotient, a sum and a product, of one pixel"}, [] {
    return window_error({0.1f, 0.2f, 0.3f, 1}, {0, 0, 1, 1});
  });
  group.equals("a viewport of no size",
               [] {
                 return values(window_position({0.5f, -0.5f, 0, 1}, {7, 9, 0, 0}));
               },
               {7, 9, 0.5});
  group.nan("a coordinate of NaN", [] { return values(window_position({not_a_number, 0, 0, 1}, {0, 0, 4, 4})); });
}

void add_relative_rows(Table& table) {
  Group group = table.of("relative_to_eye");
  const Bound rounded{rounding_unit, "relative", "the difference of nearby doubles is exact; it is rounded once"};
  for (const double offset : {1e6, 1e9, 1e15}) {
    const glm::dvec3 eye(offset, -offset, offset);
    for (const double step : {0.125, 1e-3}) {
      const glm::dvec3 position = eye + glm::dvec3(step, 2 * step, -step);  // rounded as any world position is
      group.close(fmt::format("{:g} m apart, {:.0e} m from the origin", step, offset), rounded,
                  [=] { return each_relative(values(relative_to_eye(position, eye)), values(position - eye)); });
    }
  }
  group.equals("position = eye", [] { return values(relative_to_eye(glm::dvec3(1e300), glm::dvec3(1e300))); },
               {0, 0, 0});
  group.close("the eye near, the position 1e30 m away", rounded, [] {
    return each_relative(values(relative_to_eye(glm::dvec3(1e30), {1, 2, 3})), Values(3, 1e30));
  });
  group.equals("a difference below the smallest float", [] { return values(relative_to_eye(glm::dvec3(1e-60), {})); },
               {0, 0, 0});
  group.nan("a position of NaN", [] { return values(relative_to_eye(glm::dvec3(double(not_a_number)), {})); });
  group.close("3000 random pairs, up to 1e7 m from the origin and 100 m apart", rounded, [] {
    return worst_of(3000, 50, [](Trial& t) {
      const glm::dvec3 eye = t.in_cube(1e7), position = eye + t.in_cube(100);
      return each_relative(values(relative_to_eye(position, eye)), values(position - eye));
    });
  });
}

}  // namespace

void add_window_rows(Table& table) {
  add_window_position_rows(table);
  add_relative_rows(table);
}

}  // namespace atelier::stability
