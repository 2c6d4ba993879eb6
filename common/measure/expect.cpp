#include "measure/expect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace atelier::measure {
namespace {

using Kind = Expectation::Kind;

std::string place_of(const SweepResult& result, const std::string& curve) {
  return curve.empty() ? result.plan.name : fmt::format("{}, {} {}", result.plan.name, result.plan.curves_by, curve);
}

double error_at(const SweepResult& result, const std::string& curve, const std::string& value) {
  const auto point = std::find_if(result.points.begin(), result.points.end(),
                                  [&](const Point& p) { return p.curve == curve && p.value == value; });
  return point == result.points.end() ? std::nan("") : point->error;
}

/// Of one curve; counts are exact.
double noise_of(const SweepResult& result, std::span<const glm::dvec2> points) {
  return result.plan.count.empty() ? noise_floor(points) : 0;
}

Finding slope_finding(const SweepResult& result, const Expectation& e, const std::string& curve) {
  const std::vector<glm::dvec2> points = curve_points(result, curve);
  const auto fit = fit_power(points, noise_of(result, points), e.range);
  const std::string expected = fmt::format("expected {} +- {}", e.number, e.tolerance);
  if (!fit) return {false, fmt::format("too few points above the noise floor for a slope, {}", expected), {}};
  return {std::abs(fit->slope - e.number) <= e.tolerance,
          fmt::format("slope {:.3f} from {:g} to {:g}, {}", fit->slope, fit->from, fit->to, expected),
          {}};
}

Finding order_finding(const SweepResult& result, const Expectation& e, const std::string& curve) {
  std::vector<std::string> words;
  bool met = true;
  double before = -std::numeric_limits<double>::infinity();
  for (const std::string& value : e.values) {
    const double error = error_at(result, curve, value);
    met = met && error >= before;
    before = error;
    words.push_back(fmt::format("{} {:.3g}", value, error));
  }
  return {met, fmt::format("{}; expected not to fall in this order", fmt::join(words, ", ")), {}};
}

Finding at_most_finding(const SweepResult& result, const Expectation& e, const std::string& curve) {
  double most = -std::numeric_limits<double>::infinity();
  std::string value;
  for (const Point& p : result.points)
    if (p.curve == curve && p.error >= most) most = p.error, value = p.value;
  return {most <= e.number, fmt::format("at most {:.3g} (at {}), expected at most {:g}", most, value, e.number), {}};
}

Finding at_finding(const SweepResult& result, const Expectation& e, const std::string& curve) {
  const double error = error_at(result, curve, e.values[0]);
  return {std::abs(error - e.number) <= e.tolerance,
          fmt::format("{:.4g} at {}, expected {:g} +- {:g}", error, e.values[0], e.number, e.tolerance),
          {}};
}

Finding finding_of(const SweepResult& result, const Expectation& e, const std::string& curve) {
  switch (e.kind) {
    case Kind::slope:
      return slope_finding(result, e, curve);
    case Kind::order:
      return order_finding(result, e, curve);
    case Kind::at_most:
      return at_most_finding(result, e, curve);
    case Kind::at:
      break;
  }
  return at_finding(result, e, curve);
}

}  // namespace

std::vector<Finding> findings(const SweepResult& result) {
  std::vector<Finding> all;
  for (const Expectation& e : result.plan.expect)
    for (const std::string& curve : curves_of(result)) {
      if (!e.curve.empty() && e.curve != curve) continue;
      Finding finding = finding_of(result, e, curve);
      finding.words = place_of(result, curve) + ": " + finding.words;
      finding.reason = e.reason;
      all.push_back(std::move(finding));
    }
  return all;
}

std::optional<Fit> fit_of(const SweepResult& result, const std::string& curve) {
  if (!result.numeric || result.plan.metric == Metric::mean) return std::nullopt;
  std::optional<glm::dvec2> range;
  for (const Expectation& e : result.plan.expect)
    if (e.kind == Kind::slope && (e.curve.empty() || e.curve == curve)) range = e.range;
  const std::vector<glm::dvec2> points = curve_points(result, curve);
  return fit_power(points, noise_of(result, points), range);
}

}  // namespace atelier::measure
