#include "measure/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "image/error.hpp"

namespace atelier::measure {
namespace {

using Chosen = std::map<std::string, SettingValue>;

Case with(Case ask, const Chosen& settings, std::string name) {
  for (const auto& [setting, value] : settings) ask.settings[setting] = value;
  ask.name = std::move(name);
  return ask;
}

/// Makes every truth once, since many points of a sweep share theirs.
class Truths {
 public:
  explicit Truths(const Truth& truth) : truth_(truth) {}

  /// The index of this picture's truth in what make() returns.
  std::size_t place_for(const Case& picture) {
    Case asked = with(picture, truth_.settings, "truth");
    const std::string key = to_json(asked).dump();
    const auto known = std::find(keys_.begin(), keys_.end(), key);
    if (known != keys_.end()) return std::size_t(known - keys_.begin());
    asked.name = fmt::format("truth-{}", keys_.size());
    keys_.push_back(key), asks_.push_back(std::move(asked));
    return keys_.size() - 1;
  }

  std::vector<Image> make(const Program& program) const {
    std::vector<Image> images;
    switch (truth_.by) {
      case Truth::By::oracle:
        return trace(program, asks_, truth_.samples);
      case Truth::By::program:
        for (Drawn& drawn : draw(program, asks_)) images.push_back(std::move(drawn.picture));
        break;
      case Truth::By::value:
      case Truth::By::none:
        break;
    }
    return images;
  }

 private:
  const Truth& truth_;
  std::vector<std::string> keys_;
  std::vector<Case> asks_;
};

/// Fills in the errors and costs of points whose `chosen` is set.
void measure_points(const Program& program, const Listing& listing, const Case& ask, const Truth& truth, Metric metric,
                    const SweepOptions& options, std::vector<Point>& points) {
  std::vector<Case> cases;
  std::vector<std::size_t> places;
  Truths truths(truth);
  const bool has_picture = truth.by == Truth::By::oracle || truth.by == Truth::By::program;
  for (std::size_t i = 0; i < points.size(); ++i) {
    cases.push_back(with(ask, points[i].chosen, fmt::format("picture-{}", i)));
    if (has_picture) places.push_back(truths.place_for(cases.back()));
  }
  const std::vector<Image> made = truths.make(program);
  std::vector<Drawn> drawn = draw(program, cases, options.repeats);
  const Encoding encoding = listing.encoding_of(ask.output);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point& point = points[i];
    try {
      const Image& picture = drawn[i].picture;
      const Image& right = places.empty() ? picture : made[places[i]];
      point.error = error_of(picture, right, metric, encoding);
      if (!places.empty()) point.rmse = error_of(picture, right, Metric::rmse, encoding);
      if (!places.empty() && encoding != Encoding::data) point.flip = error_of(picture, right, Metric::flip, encoding);
    } catch (const Error& error) {
      throw Error(fmt::format("'{}' at {}: {}", ask.name, point.value, error.what()));
    }
    point.cost = std::move(drawn[i].cost);
  }
}

std::optional<double> number_of(const SettingValue& value) {
  if (const int* whole = std::get_if<int>(&value)) return *whole;
  if (const double* real = std::get_if<double>(&value)) return *real;
  return std::nullopt;
}

}  // namespace

SweepResult run_sweep(const Program& program, const Listing& listing, const Sweep& sweep, const SweepOptions& options) {
  SweepResult result{.plan = sweep};
  if (sweep.values.empty())
    for (const SettingSpec& spec : listing.settings)
      if (spec.name == sweep.setting) result.plan.values = default_values(spec);
  const auto& values = result.plan.values;
  result.numeric = std::all_of(values.begin(), values.end(), [](const auto& v) { return number_of(v).has_value(); });

  const auto add = [&](const Chosen& chosen, const std::string& curve) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      Point point{.chosen = chosen, .curve = curve, .value = setting_text(values[i])};
      point.chosen[sweep.setting] = values[i];
      point.x = result.numeric ? *number_of(values[i]) : double(i);
      result.points.push_back(std::move(point));
    }
  };
  if (sweep.curves.empty()) add({}, "");
  for (const SettingValue& curve : sweep.curves) add({{sweep.curves_by, curve}}, setting_text(curve));
  measure_points(program, listing, sweep.ask, sweep.truth, sweep.metric, options, result.points);
  if (!sweep.count.empty())
    for (Point& point : result.points)
      point.error = count_of(point.cost, sweep.count, fmt::format("sweep '{}': count", sweep.name));
  return result;
}

FrontResult run_front(const Program& program, const Listing& listing, const Front& front, const SweepOptions& options) {
  FrontResult result{.plan = front, .points = {Point{}}};
  for (const auto& [setting, values] : front.grid) {
    std::vector<Point> longer;
    for (const Point& point : result.points)
      for (const SettingValue& value : values) {
        longer.push_back(point);
        longer.back().chosen[setting] = value;
        longer.back().value += fmt::format("{}{}={}", point.value.empty() ? "" : " ", setting, setting_text(value));
      }
    result.points = std::move(longer);
  }
  for (std::size_t i = 0; i < result.points.size(); ++i) result.points[i].x = double(i);
  measure_points(program, listing, front.ask, front.truth, front.metric, options, result.points);
  return result;
}

std::vector<std::string> curves_of(const SweepResult& result) {
  std::vector<std::string> curves;
  for (const Point& point : result.points)
    if (curves.empty() || curves.back() != point.curve) curves.push_back(point.curve);
  return curves;
}

std::vector<glm::dvec2> curve_points(const SweepResult& result, const std::string& curve) {
  std::vector<glm::dvec2> points;
  for (const Point& point : result.points)
    if (point.curve == curve) points.emplace_back(point.x, point.error);
  return points;
}

std::string quantity_of(const Sweep& sweep) {
  return sweep.count.empty() ? to_string(sweep.metric) : sweep.count;
}

double floor_of(const SweepResult& result) {
  if (result.plan.metric == Metric::mean || !result.plan.count.empty()) return 0;
  std::vector<glm::dvec2> all;
  for (const Point& point : result.points) all.emplace_back(point.x, point.error);
  return noise_floor(all);
}

}  // namespace atelier::measure
