#include "measure/fit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace atelier::measure {

double Fit::at(double x) const {
  return factor * std::pow(x, slope);
}

std::optional<Fit> fit_power(std::span<const glm::dvec2> points, double floor, std::optional<glm::dvec2> range) {
  std::vector<glm::dvec2> logs;
  Fit fit;
  for (const glm::dvec2& p : points) {
    if (!(p.x > 0 && p.y > 0 && p.y > floor * floor_margin)) continue;
    if (range && (p.x < range->x || p.x > range->y)) continue;
    fit.from = logs.empty() ? p.x : std::min(fit.from, p.x);
    fit.to = logs.empty() ? p.x : std::max(fit.to, p.x);
    logs.emplace_back(std::log10(p.x), std::log10(p.y));
  }
  if (logs.size() < 3 || fit.from == fit.to) return std::nullopt;

  // Centred on the mean to avoid cancellation.
  const double count = double(logs.size());
  glm::dvec2 mean(0);
  for (const glm::dvec2& p : logs) mean += p / count;
  double xx = 0, xy = 0;
  for (const glm::dvec2& p : logs) xx += (p.x - mean.x) * (p.x - mean.x), xy += (p.x - mean.x) * (p.y - mean.y);
  fit.slope = xy / xx;
  fit.factor = std::pow(10, mean.y - fit.slope * mean.x);
  double squares = 0;
  for (const glm::dvec2& p : logs) squares += std::pow(p.y - mean.y - fit.slope * (p.x - mean.x), 2);
  fit.deviation = std::sqrt(squares / count);
  fit.points = int(logs.size());
  return fit;
}

double noise_floor(std::span<const glm::dvec2> points) {
  double least = 0;
  for (const glm::dvec2& p : points)
    if (p.y > 0 && (least == 0 || p.y < least)) least = p.y;
  return least;
}

}  // namespace atelier::measure
