#include "measure/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"
#include "case/setting_json.hpp"
#include "measure/median.hpp"
#include "measure/metric_json.hpp"

namespace atelier::measure {
namespace {

using strict_json::Json;

constexpr std::size_t plan_limit = 1 << 16;  ///< bytes

BaselineRow row_of(const Json& json, const std::string& where) {
  strict_json::refuse_unknown(json, {"name", "settings", "baseline_settings", "aim", "no_larger_error"}, where);
  BaselineRow row;
  row.name = strict_json::text(strict_json::required(json, "name", where), where + ": name", 60);
  if (const Json* settings = strict_json::optional(json, "settings"))
    row.settings = settings_from_json(*settings, where + ": settings");
  if (const Json* settings = strict_json::optional(json, "baseline_settings"))
    row.baseline_settings = settings_from_json(*settings, where + ": baseline_settings");
  if (const Json* aim = strict_json::optional(json, "aim"))
    row.aim = strict_json::number(*aim, where + ": aim", 0.1, 100);
  if (const Json* flag = strict_json::optional(json, "no_larger_error"))
    row.no_larger_error = strict_json::boolean(*flag, where + ": no_larger_error");
  return row;
}

/// The seconds per frame of the baseline and of a row in one round.
struct Pair {
  double baseline = 0, row = 0;
};

using SettingValues = std::map<std::string, SettingValue>;

/// `first`, and of `second` what it does not have.
SettingValues merged(SettingValues first, const SettingValues& second) {
  first.insert(second.begin(), second.end());
  return first;
}

Case picture_of(const BaselinePlan& plan, const std::string& output, const SettingValues& settings) {
  return {.name = "picture", .scene = plan.scene, .size = plan.size, .settings = settings, .output = output};
}

/// "shadow-demo", "shadow-demo, frame.format=8".
std::string name_of_baseline(const BaselinePlan& plan, const SettingValues& settings) {
  std::string name = plan.program;
  for (const auto& [setting, value] : settings) name += fmt::format(", {}={}", setting, setting_text(value));
  return name;
}

class Comparison {
 public:
  Comparison(const BaselinePlan& plan, const Program& step) : plan_(plan) {
    colour_ = trace(step, {picture_of(plan, "colour", plan.settings)}, plan.samples).front();
    output_ = trace(step, {picture_of(plan, plan.output, plan.settings)}, 1).front();
  }

  double seconds(const Program& program, const SettingValues& settings, int frames) const {
    return drawn(program, settings, "colour", frames).cost.times.value().median;
  }

  /// The errors of a program with these settings; the times are not filled in.
  Compared errors(const std::string& name, const Program& program, const SettingValues& settings) const {
    const Image colour = drawn(program, settings, "colour", 0).picture;
    const Image output = drawn(program, settings, plan_.output, 0).picture;
    return {.name = name,
            .rmse = error_of(colour, colour_, ErrorMetric::rmse),
            .error = error_of(output, output_, plan_.metric, Encoding::data)};
  }

 private:
  Drawn drawn(const Program& program, const SettingValues& settings, const std::string& output, int frames) const {
    return std::move(draw(program, {picture_of(plan_, output, settings)}, frames).front());
  }

  const BaselinePlan& plan_;
  Image colour_, output_;
};

}  // namespace

BaselinePlan parse_baseline_plan(std::string_view text, const std::string& where) {
  const Json json = strict_json::parse(text, where);
  strict_json::refuse_unknown(
      json, {"baseline", "scene", "size", "settings", "output", "metric", "samples", "rows"}, where);
  const auto member = [&](const char* name) -> const Json& { return strict_json::required(json, name, where); };
  BaselinePlan plan;
  plan.program = strict_json::name(member("baseline"), where + ": baseline");
  plan.output = strict_json::name(member("output"), where + ": output", "-_");
  plan.metric = metric_from_json(member("metric"), where + ": metric");
  if (plan.metric == ErrorMetric::mean)
    throw Error(where + ": metric: mean is not allowed: it is no difference from the ground truth");
  if (const Json* settings = strict_json::optional(json, "settings"))
    plan.settings = settings_from_json(*settings, where + ": settings");
  plan.samples = strict_json::integer(member("samples"), where + ": samples", 1, 64);
  // Scene and size are checked as in a case.
  const Case picture = parse_case({{"name", "picture"}, {"scene", member("scene")}, {"size", member("size")}}, where);
  plan.scene = picture.scene;
  plan.size = picture.size;
  const Json& rows = member("rows");
  if (!rows.is_array() || rows.empty()) strict_json::refuse(rows, where + ": rows", "a list of at least one row");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    BaselineRow row = row_of(rows[i], fmt::format("{}: row {}", where, i + 1));
    row.settings = merged(std::move(row.settings), plan.settings);
    plan.rows.push_back(std::move(row));
  }
  return plan;
}

BaselinePlan read_baseline_plan(const std::filesystem::path& file) {
  return parse_baseline_plan(read_file(file, plan_limit), file.string());
}

BaselineComparison compare_with_baseline(const BaselinePlan& plan, const Program& step, const Program& baseline,
                                         int rounds, int frames) {
  const Comparison comparison(plan, step);
  std::vector<std::vector<Pair>> pairs(plan.rows.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t row = 0; row < plan.rows.size(); ++row) {
      const double before = comparison.seconds(baseline, plan.rows[row].baseline_settings, frames);
      pairs[row].push_back({before, comparison.seconds(step, plan.rows[row].settings, frames)});
    }

  BaselineComparison all;
  std::vector<SettingValues> drawn_with;              // parallel to all.baselines
  std::vector<std::vector<double>> baseline_seconds;  // parallel to all.baselines
  for (std::size_t row = 0; row < plan.rows.size(); ++row) {
    const BaselineRow& planned = plan.rows[row];
    const auto known = std::ranges::find(drawn_with, planned.baseline_settings);
    const auto against = std::size_t(known - drawn_with.begin());
    if (known == drawn_with.end()) {
      drawn_with.push_back(planned.baseline_settings);
      baseline_seconds.emplace_back();
      all.baselines.push_back(
          comparison.errors(name_of_baseline(plan, planned.baseline_settings), baseline, planned.baseline_settings));
    }
    Compared compared = comparison.errors(planned.name, step, planned.settings);
    compared.against = against;
    std::vector<double> seconds, ratios;
    for (const Pair& pair : pairs[row]) {
      baseline_seconds[against].push_back(pair.baseline);
      seconds.push_back(pair.row);
      ratios.push_back(pair.baseline / pair.row);
    }
    compared.seconds = median(seconds);
    const Spread ratio = spread_of(ratios);
    compared.ratio = ratio.median;
    compared.least = ratio.least;
    compared.most = ratio.most;
    all.rows.push_back(std::move(compared));
  }
  for (std::size_t i = 0; i < all.baselines.size(); ++i) all.baselines[i].seconds = median(baseline_seconds[i]);
  return all;
}

bool reaches_aim(const BaselineRow& row, const Compared& compared, const Compared& baseline) {
  constexpr double equal = 1.01;
  const bool as_accurate = compared.rmse <= equal * baseline.rmse && compared.error <= equal * baseline.error;
  return compared.ratio >= row.aim && (as_accurate || !row.no_larger_error);
}

}  // namespace atelier::measure
