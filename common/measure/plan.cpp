#include "measure/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/strict_json.hpp"
#include "case/setting_json.hpp"
#include "measure/metric_json.hpp"

namespace atelier::measure {
namespace {

using strict_json::Json;

constexpr double huge = 1e300;
constexpr std::size_t max_values = 64, max_combinations = 256;

/// A list of values without duplicates.
std::vector<SettingValue> values_of(const Json& json, const std::string& where) {
  if (!json.is_array() || json.empty() || json.size() > max_values)
    strict_json::refuse(json, where, fmt::format("a list of 1..{} values", max_values));
  std::vector<SettingValue> values;
  for (const Json& each : json) {
    values.push_back(setting_from_json(each, where));
    if (std::count(values.begin(), values.end(), values.back()) > 1)
      strict_json::refuse(each, where, "each value once");
  }
  return values;
}

/// The picture to draw; its members are read as in a case.
Case ask_of(const Json& object, const std::string& where) {
  Json asked = Json::object();
  for (const char* member : {"name", "scene", "size", "camera", "output", "settings"})
    if (const Json* value = strict_json::optional(object, member)) asked[member] = *value;
  return parse_case(asked, where);
}

Truth truth_of(const Json& object, const std::string& where) {
  Truth truth;
  const Json* given = strict_json::optional(object, "truth");
  if (!given) return truth;
  const std::string place = where + ": truth";
  if (given->is_number()) {
    truth.by = Truth::By::value;
    truth.value = strict_json::number(*given, place, -huge, huge);
    return truth;
  }
  strict_json::refuse_unknown(*given, {"by", "settings", "samples"}, place);
  const std::string by =
      strict_json::one_of(strict_json::required(*given, "by", place), place + ": by", {"oracle", "program"});
  truth.by = by == "oracle" ? Truth::By::oracle : Truth::By::program;
  if (const Json* settings = strict_json::optional(*given, "settings"))
    truth.settings = settings_from_json(*settings, place + ": settings");
  if (const Json* samples = strict_json::optional(*given, "samples")) {
    if (truth.by != Truth::By::oracle)
      strict_json::refuse(*samples, place + ": samples", "no value unless by is oracle");
    truth.samples = strict_json::integer(*samples, place + ": samples", 1, 64);
  }
  return truth;
}

Metric metric_of(const Json& object, const Truth& truth, Metric fallback, const std::string& where) {
  const Json* given = strict_json::optional(object, "metric");
  const Metric metric = given ? metric_from_json(*given, where + ": metric") : fallback;
  if ((metric == Metric::mean) != (truth.by == Truth::By::value))
    throw Error(
        fmt::format("{}: metric: {} is not allowed; a truth that is a number needs 'mean', other truths another metric",
                    where, to_string(metric)));
  return metric;
}

Expectation expectation_of(const Json& object, const std::string& where) {
  strict_json::refuse_unknown(
      object, {"slope", "order", "at_most", "at", "is", "tolerance", "range", "curve", "reason"}, where);
  Expectation e;
  e.reason = strict_json::text(strict_json::required(object, "reason", where), where + ": reason");
  if (const Json* curve = strict_json::optional(object, "curve"))
    e.curve = setting_text(setting_from_json(*curve, where + ": curve"));
  const auto member = [&](const char* name) { return strict_json::optional(object, name); };
  const int kinds = !!member("slope") + !!member("order") + !!member("at_most") + !!member("at");
  if (kinds != 1) throw Error(where + ": it takes exactly one of slope, order, at_most and at");
  const auto only_with = [&](const char* name, bool right) {
    if (member(name) && !right)
      throw Error(fmt::format("{}: {} is not allowed for this kind of expectation", where, name));
  };
  only_with("is", member("at"));
  only_with("range", member("slope"));
  only_with("tolerance", member("slope") || member("at"));
  const auto tolerance = [&] {
    e.tolerance =
        strict_json::number(strict_json::required(object, "tolerance", where), where + ": tolerance", 0, huge);
  };
  if (const Json* slope = member("slope")) {
    e.number = strict_json::number(*slope, where + ": slope", -16, 16);
    tolerance();
    if (const Json* range = member("range")) {
      const auto ends = strict_json::vector(*range, where + ": range", 2);
      if (!(ends[0] > 0 && ends[0] < ends[1]))
        strict_json::refuse(*range, where + ": range", "[from, to], 0 < from < to");
      e.range = {ends[0], ends[1]};
    }
  } else if (const Json* order = member("order")) {
    e.kind = Expectation::Kind::order;
    for (const SettingValue& value : values_of(*order, where + ": order")) e.values.push_back(setting_text(value));
    if (e.values.size() < 2) strict_json::refuse(*order, where + ": order", "two values or more");
  } else if (const Json* most = member("at_most")) {
    e.kind = Expectation::Kind::at_most;
    e.number = strict_json::number(*most, where + ": at_most", 0, huge);
  } else {
    e.kind = Expectation::Kind::at;
    e.values = {setting_text(setting_from_json(*member("at"), where + ": at"))};
    e.number = strict_json::number(strict_json::required(object, "is", where), where + ": is", -huge, huge);
    tolerance();
  }
  return e;
}

std::string name_of(const Json& object, const std::string& where, std::set<std::string>& taken) {
  const std::string name = strict_json::name(strict_json::required(object, "name", where), where + ": name");
  if (!taken.insert(name).second) throw Error(fmt::format("{}: name: '{}' appears twice", where, name));
  return name;
}

std::string text_of(const Json& object, const char* member, const std::string& where) {
  return strict_json::text(strict_json::required(object, member, where), where + ": " + member, 120);
}

bool flag_of(const Json& object, const char* member, const std::string& where) {
  const Json* given = strict_json::optional(object, member);
  return given && strict_json::boolean(*given, where + ": " + member);
}

Sweep sweep_of(const Json& object, const std::string& file, std::set<std::string>& taken) {
  strict_json::refuse_unknown(
      object,
      {"name", "title", "scene", "size", "camera", "output", "settings", "setting", "values", "curves_by", "curves",
       "truth", "metric", "count", "x", "y", "linear", "handout", "expect"},
      file + ": sweep");
  Sweep sweep;
  sweep.name = name_of(object, file + ": sweep", taken);
  const std::string where = fmt::format("{}: sweep '{}'", file, sweep.name);
  sweep.title = text_of(object, "title", where);
  sweep.ask = ask_of(object, where);
  sweep.setting = text_of(object, "setting", where);
  if (const Json* values = strict_json::optional(object, "values"))
    sweep.values = values_of(*values, where + ": values");
  const Json *by = strict_json::optional(object, "curves_by"), *curves = strict_json::optional(object, "curves");
  if (!by != !curves) throw Error(where + ": curves_by and curves need each other");
  if (by) sweep.curves_by = text_of(object, "curves_by", where), sweep.curves = values_of(*curves, where + ": curves");
  if (by && sweep.curves_by == sweep.setting) strict_json::refuse(*by, where + ": curves_by", "another setting");
  for (const std::string& name : {sweep.setting, sweep.curves_by})
    if (sweep.ask.settings.contains(name))
      throw Error(fmt::format("{}: settings: {} is swept, so it cannot be fixed", where, name));
  if (const Json* count = strict_json::optional(object, "count")) {
    for (const char* member : {"truth", "metric"})
      if (strict_json::optional(object, member))
        throw Error(
            fmt::format("{}: {} is not allowed beside count: a count is not compared with a truth", where, member));
    sweep.count = strict_json::name(*count, where + ": count", "_");
    sweep.truth.by = Truth::By::none;
  } else {
    sweep.truth = truth_of(object, where);
    sweep.metric = metric_of(object, sweep.truth, Metric::rmse, where);
  }
  sweep.x_label = text_of(object, "x", where), sweep.y_label = text_of(object, "y", where);
  sweep.linear = flag_of(object, "linear", where), sweep.handout = flag_of(object, "handout", where);
  if (const Json* expect = strict_json::optional(object, "expect")) {
    if (!expect->is_array()) strict_json::refuse(*expect, where + ": expect", "a list of expectations");
    for (const Json& each : *expect) sweep.expect.push_back(expectation_of(each, where + ": expect"));
  }
  return sweep;
}

Front front_of(const Json& object, const std::string& file, std::set<std::string>& taken) {
  strict_json::refuse_unknown(
      object, {"name", "title", "scene", "size", "camera", "output", "settings", "grid", "truth", "metric"},
      file + ": front");
  Front front;
  front.name = name_of(object, file + ": front", taken);
  const std::string where = fmt::format("{}: front '{}'", file, front.name);
  front.title = text_of(object, "title", where);
  front.ask = ask_of(object, where);
  const Json& grid = strict_json::required(object, "grid", where);
  if (!grid.is_object() || grid.empty())
    strict_json::refuse(grid, where + ": grid", "an object of settings and values");
  std::size_t combinations = 1;
  for (const auto& [name, values] : grid.items()) {
    front.grid.emplace_back(name, values_of(values, where + ": grid: " + name));
    combinations *= front.grid.back().second.size();
    if (front.ask.settings.contains(name))
      throw Error(fmt::format("{}: settings: {} is in the grid, so it cannot be fixed", where, name));
  }
  if (combinations > max_combinations)
    throw Error(fmt::format("{}: grid: {} combinations are not allowed; it takes up to {}", where, combinations,
                            max_combinations));
  front.truth = truth_of(object, where);
  front.metric = metric_of(object, front.truth, Metric::flip, where);
  return front;
}

}  // namespace

Plan parse_plan(const std::string& text, const std::string& where) {
  const Json document = strict_json::parse(text, where);
  strict_json::refuse_unknown(document, {"schema", "step", "sweeps", "fronts", "not_measured"}, where);
  strict_json::integer(strict_json::required(document, "schema", where), where + ": schema", 1, 1);
  Plan plan;
  plan.step = strict_json::name(strict_json::required(document, "step", where), where + ": step");
  std::set<std::string> taken;
  const Json& sweeps = strict_json::required(document, "sweeps", where);
  if (!sweeps.is_array()) strict_json::refuse(sweeps, where + ": sweeps", "a list of sweeps");
  for (const Json& each : sweeps) plan.sweeps.push_back(sweep_of(each, where, taken));
  if (const Json* fronts = strict_json::optional(document, "fronts")) {
    if (!fronts->is_array()) strict_json::refuse(*fronts, where + ": fronts", "a list of fronts");
    for (const Json& each : *fronts) plan.fronts.push_back(front_of(each, where, taken));
  }
  if (const Json* others = strict_json::optional(document, "not_measured")) {
    if (!others->is_object())
      strict_json::refuse(*others, where + ": not_measured", "an object of settings and reasons");
    for (const auto& [name, reason] : others->items())
      plan.not_measured[name] = strict_json::text(reason, where + ": not_measured: " + name);
  }
  return plan;
}

Plan read_plan(const std::filesystem::path& file) {
  return parse_plan(read_file(file), file.string());
}

}  // namespace atelier::measure
