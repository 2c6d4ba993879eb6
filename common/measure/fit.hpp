// Fits a power law to an error curve, and finds its noise floor.
#pragma once

#include <optional>
#include <span>

#include <glm/glm.hpp>

namespace atelier::measure {

/// y = factor * x^slope, by least squares in (log x, log y).
struct Fit {
  double slope = 0, factor = 1;
  double deviation = 0;     ///< root mean square of log10(y / fitted); 0.3 is a factor of two
  double from = 0, to = 0;  ///< the range of x in the fit
  int points = 0;
  double at(double x) const;
};

/// Fits the points with x > 0, y > 0 and y > floor * floor_margin, and with x in the closed `range` if one is given.
/// Nothing if fewer than three points remain (two fit any line) or all have the same x.
std::optional<Fit> fit_power(std::span<const glm::dvec2> points, double floor = 0,
                             std::optional<glm::dvec2> range = std::nullopt);

/// The smallest y above zero: the error that remains at the best value of a setting, whatever its cause (float
/// rounding, the rasteriser's grid of 1/256 pixel, another approximation). 0 if there is none.
double noise_floor(std::span<const glm::dvec2> points);

/// An error sqrt((x^p)^2 + e^2), a power law plus a noise floor e, differs from x^p by about 5 % where it is 3 e.
inline constexpr double floor_margin = 3;

}  // namespace atelier::measure
