#include "scene/round_enough.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace atelier {
namespace {

constexpr int fewest = 3, most = 65536;  // the range of make_cylinder_wall

void require(bool fine, const char* what, double value) {
  if (!fine)
    throw Error(fmt::format("segments_for: {} {} must be finite and above 0 (an angle below pi)", what, value));
}

}  // namespace

int segments_for(const RoundView& view) {
  require(std::isfinite(view.radius) && view.radius > 0, "radius", view.radius);
  require(std::isfinite(view.distance) && view.distance > 0, "distance", view.distance);
  require(view.fov_y > 0 && view.fov_y < std::numbers::pi, "fov_y", view.fov_y);
  require(view.height > 0, "height", view.height);
  require(std::isfinite(view.pixels) && view.pixels > 0, "pixels", view.pixels);
  const double pixel = 2 * view.distance * std::tan(view.fov_y / 2) / view.height;
  // 1 - cos x = 2 sin^2(x / 2), which avoids cancellation for large n.
  const double half_sine = std::sqrt(view.pixels * pixel / (2 * view.radius));
  if (half_sine >= 1) return fewest;
  const double exact = std::numbers::pi / (2 * std::asin(half_sine));
  // Do not round up a number that is an integer except for rounding error.
  return int(std::clamp(std::ceil(exact * (1 - 1e-12)), double(fewest), double(most)));
}

}  // namespace atelier
