// Random inputs that are the same in every run and on every machine: number k of trial i is a hash of (seed, i, k), so
// a trial that fails can be looked at alone.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "scene/noise.hpp"

namespace atelier::stability {

/// The numbers of one trial.
class Trial {
 public:
  Trial(std::uint64_t seed, std::int64_t index) : seed_(seed), index_(index) {}

  double between(double low, double high) { return low + (high - low) * hash01(seed_, index_, next_++); }
  /// Evenly spread in the logarithm, for sizes that span many powers of ten; 0 < low < high.
  double size_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  double sign() { return between(0, 1) < 0.5 ? -1 : 1; }
  glm::dvec3 in_cube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
  /// A unit vector, evenly spread over the sphere (Archimedes: its height is evenly spread over -1..1).
  glm::dvec3 direction() {
    const double z = between(-1, 1), phi = between(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }

 private:
  std::uint64_t seed_;
  std::int64_t index_;
  std::int64_t next_ = 0;
};

/// The largest error(trial) over `count` trials; infinite where one is NaN.
template <class Error>
double worst_of(int count, std::uint64_t seed, Error&& error) {
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    Trial trial(seed, i);
    const double here = error(trial);
    if (!(here <= worst)) worst = std::isnan(here) ? double(INFINITY) : here;
  }
  return worst;
}

}  // namespace atelier::stability
