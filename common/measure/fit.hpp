// What a curve of errors says: the power by which it falls, and where that stops.
#pragma once

#include <optional>
#include <span>

#include <glm/glm.hpp>

namespace atelier::measure {

/// y = factor * x^slope, by least squares on (log x, log y).
struct Fit {
  double slope = 0, factor = 1;
  double deviation = 0;     ///< root mean square of log10(y / fitted): 0.3 is a factor of two
  double from = 0, to = 0;  ///< the range of x that was fitted
  int points = 0;
  double at(double x) const;
};

/// The points that lie above `floor` times floor_margin, where x and y are above zero, and x within `range` (closed)
/// where one is given. Nothing where fewer than three are left, or all have the same x: two points fit any line.
std::optional<Fit> fit_power(std::span<const glm::dvec2> points, double floor = 0,
                             std::optional<glm::dvec2> range = std::nullopt);

/// The smallest y above zero: the error that remains at the best value of a setting, whatever it is made of (rounding
/// of floats, the rasteriser's grid of 1/256 pixel, another approximation). 0 where there is none.
double noise_floor(std::span<const glm::dvec2> points);

/// An error that falls as x^p onto a floor e lies, as the root of the sum of both squares, within 5 % of the pure power
/// where it is above three times e.
inline constexpr double floor_margin = 3;

}  // namespace atelier::measure
