#include "measure/charts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "measure/expect.hpp"

namespace atelier::measure {
namespace {

/// Whether the x values span at least one decade, so that a logarithmic axis makes sense.
bool spans_a_decade(const SweepResult& result) {
  double low = 0, high = 0;
  for (const Point& point : result.points)
    if (point.x > 0) low = low == 0 ? point.x : std::min(low, point.x), high = std::max(high, point.x);
  return result.numeric && low > 0 && high >= 10 * low;
}

Axis value_axis(const SweepResult& result) {
  Axis axis{.label = result.plan.x_label};
  if (spans_a_decade(result)) axis.scale = Scale::logarithmic;
  if (!result.numeric)
    for (std::size_t i = 0; i < result.plan.values.size(); ++i)
      axis.ticks.push_back({double(i), setting_text(result.plan.values[i])});
  return axis;
}

Scale error_scale(const SweepResult& result) {
  return result.plan.linear ? Scale::linear : Scale::logarithmic;
}

std::string title_of_curve(const SweepResult& result, const std::string& curve) {
  const std::string& setting = result.plan.curves_by;  // "specular.power": the group is left out
  return curve.empty() ? std::string() : fmt::format("{} {}", setting.substr(setting.find('.') + 1), curve);
}

/// The fitted power law as a dashed line in the colour of its curve, over the range of the fit.
Curve line_of(const Fit& fit, int colour) {
  return {.title = fmt::format("slope {:.2f}", fit.slope),
          .points = {{fit.from, fit.at(fit.from)}, {fit.to, fit.at(fit.to)}},
          .style = Curve::Style::dashes,
          .colour = colour};
}

constexpr double milliseconds = 1e3;

Axis time_axis() {
  return {.label = "time of a frame, ms", .scale = Scale::logarithmic};
}

}  // namespace

Plot chart_of_errors(const SweepResult& result) {
  const Sweep& sweep = result.plan;
  Plot plot{.title = sweep.title, .x = value_axis(result), .y = {.label = sweep.y_label, .scale = error_scale(result)}};
  std::vector<Curve> fits;
  int colour = 0;
  for (const std::string& curve : curves_of(result)) {
    plot.curves.push_back({.title = title_of_curve(result, curve),
                           .points = curve_points(result, curve),
                           .style = result.numeric ? Curve::Style::marks_and_line : Curve::Style::marks,
                           .colour = colour});
    const auto fit = fit_of(result, curve);
    // Draw the slope only if the plan expects one.
    const bool expected = std::any_of(sweep.expect.begin(), sweep.expect.end(), [&](const Expectation& e) {
      return e.kind == Expectation::Kind::slope && (e.curve.empty() || e.curve == curve);
    });
    if (fit && expected && spans_a_decade(result)) fits.push_back(line_of(*fit, colour));
    ++colour;
  }
  plot.curves.insert(plot.curves.end(), fits.begin(), fits.end());
  if (const double floor = floor_of(result); floor > 0 && !fits.empty())
    plot.levels.push_back({floor, fmt::format("noise floor {:.1e}", floor), true});
  return plot;
}

std::optional<Plot> chart_of_times(const SweepResult& result) {
  if (result.plan.metric == Metric::mean) return std::nullopt;
  const bool counts = !result.plan.count.empty();
  Plot plot = counts ? Plot{.title = result.plan.title + ": time", .x = value_axis(result), .y = time_axis()}
                     : Plot{.title = result.plan.title + ": error against time",
                            .x = time_axis(),
                            .y = {.label = result.plan.y_label, .scale = error_scale(result)}};
  for (const std::string& curve : curves_of(result)) {
    Curve drawn{.title = title_of_curve(result, curve), .style = Curve::Style::marks};
    for (const Point& point : result.points) {
      if (!point.cost.times) return std::nullopt;
      if (point.curve != curve) continue;
      if (counts) {
        drawn.points.emplace_back(point.x, point.cost.times->median * milliseconds);
        continue;
      }
      drawn.points.emplace_back(point.cost.times->median * milliseconds, point.error);
      drawn.spread.emplace_back(point.cost.times->least * milliseconds, point.cost.times->most * milliseconds);
    }
    plot.curves.push_back(std::move(drawn));
  }
  return plot;
}

std::optional<Plot> chart_of_front(const FrontResult& result) {
  const Ranking ranking = rank(result);
  if (ranking.front.empty()) return std::nullopt;
  Plot plot{.title = result.plan.title,
            .x = time_axis(),
            .y = {.label = "error, " + to_string(result.plan.metric), .scale = Scale::logarithmic}};
  const auto place = [&](std::size_t i) { return glm::dvec2(ranking.points[i].x * milliseconds, ranking.points[i].y); };
  Curve all{.title = "every combination", .style = Curve::Style::marks, .colour = 4},
      front{.title = "Pareto front: no other is faster and more accurate", .colour = 1};
  for (std::size_t i = 0; i < ranking.points.size(); ++i) all.points.push_back(place(i));
  for (const std::size_t i : ranking.front) front.points.push_back(place(i));
  plot.curves = {std::move(all), std::move(front)};
  if (ranking.knee) plot.marks = {{place(*ranking.knee), "recommended"}};
  return plot;
}

}  // namespace atelier::measure
