#include "scene/round_enough.hpp"

#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "catch.hpp"
#include "scene/shapes.hpp"

namespace {

using namespace atelier;
using test::error_of;
using test::mentions;

/// How far the rim of a disc of n segments stays behind the circle at the most, in pixels, when it is looked at
/// straight on: measured on the mesh, in the middle of every edge between two corners of the rim.
double widest_gap(const RoundView& view, int segments) {
  const Mesh disc = make_disc({.radius = float(view.radius), .segments = segments});
  const double focal = view.height / (2 * std::tan(view.fov_y / 2));  // pixels
  double gap = 0;
  for (std::size_t triangle = 0; triangle < disc.indices.size(); triangle += 3)
    for (std::size_t side = 0; side < 3; ++side) {
      const glm::dvec3 a(disc.vertices[disc.indices[triangle + side]].position),
          b(disc.vertices[disc.indices[triangle + (side + 1) % 3]].position);
      const bool rim = glm::length(a) > 0.999 * view.radius && glm::length(b) > 0.999 * view.radius;
      if (rim) gap = std::max(gap, (view.radius - glm::length((a + b) / 2.0)) * focal / view.distance);
    }
  return gap;
}

}  // namespace

TEST_CASE("the fewest pieces whose silhouette is within half a pixel", "[round_enough]") {
  const RoundView rows[] = {
      {.radius = 1, .distance = 4, .fov_y = 0.8, .height = 256},
      {.radius = 6, .distance = 1.97, .fov_y = 1.309, .height = 480},
      {.radius = 6, .distance = 12, .fov_y = 0.6, .height = 1080},
      {.radius = 0.05, .distance = 10, .fov_y = 1, .height = 480},
      {.radius = 1, .distance = 4, .fov_y = 0.8, .height = 256, .pixels = 0.05},
      {.radius = 100, .distance = 130, .fov_y = 0.8, .height = 2160},
  };
  for (const RoundView& view : rows) {
    INFO("radius " << view.radius << ", distance " << view.distance << ", height " << view.height);
    const int n = segments_for(view);
    REQUIRE(n > 3);
    // The corners are floats: their places are off by a ten-millionth of the radius, here at most 1e-2 pixels.
    const double rounding = 1.2e-7 * view.radius / view.distance * view.height;
    CHECK(widest_gap(view, n) <= view.pixels + rounding);
    CHECK(widest_gap(view, n - 1) > view.pixels - rounding);
  }
}

TEST_CASE("four times the pixels take twice the pieces", "[round_enough]") {
  const RoundView view{.radius = 6, .distance = 4, .fov_y = 1, .height = 1000};
  RoundView sharp = view;
  sharp.height = 4000;
  // sagitta ~ R pi^2 / (2 n^2); rounding up costs at most two pieces.
  CHECK(std::abs(segments_for(sharp) - 2 * segments_for(view)) <= 2);
}

TEST_CASE("the number of pieces stays within what a wall may have", "[round_enough]") {
  CHECK(segments_for({.radius = 1e-6, .distance = 1e6}) == 3);
  CHECK(segments_for({.radius = 1e6, .distance = 1e-6}) == 65536);
  // A hexagon's sagitta is R (1 - sqrt(3)/2): exactly allowed, it is enough.
  const double sagitta = 1 - std::sqrt(3.0) / 2, quarter = std::numbers::pi / 2;
  CHECK(segments_for({.radius = 1, .distance = 1, .fov_y = quarter, .height = 2, .pixels = sagitta * (1 + 1e-14)}) ==
        6);
  CHECK(segments_for({.radius = 1, .distance = 1, .fov_y = quarter, .height = 2, .pixels = sagitta * (1 - 1e-6)}) == 7);
}

TEST_CASE("impossible dimensions are named", "[round_enough]") {
  const struct {
    RoundView view;
    const char* name;
  } rows[] = {
      {{.radius = 0}, "radius"},      {{.radius = std::nan("")}, "radius"},
      {{.distance = -1}, "distance"}, {{.distance = std::numeric_limits<double>::infinity()}, "distance"},
      {{.fov_y = 0}, "fov_y"},        {{.fov_y = 3.2}, "fov_y"},
      {{.height = 0}, "height"},      {{.pixels = 0}, "pixels"},
  };
  for (const auto& row : rows) CHECK(mentions(error_of([&] { segments_for(row.view); }), {row.name}));
}
