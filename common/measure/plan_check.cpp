// Checks a plan against its step program: what it names must exist, and every setting must be covered.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "measure/plan.hpp"

namespace atelier::measure {
namespace {

class Checker {
 public:
  Checker(const Plan& plan, const std::vector<SettingSpec>& settings, const std::vector<std::string>& outputs)
      : plan_(plan), settings_(settings), outputs_(outputs) {}

  void sweep(const Sweep& sweep) {
    const std::string where = fmt::format("sweep '{}'", sweep.name);
    common(where, sweep.ask, sweep.truth);
    values(where, sweep.setting, sweep.values);
    if (sweep.values.empty() && default_values(known(where, sweep.setting)).empty())
      throw Error(fmt::format("{}: {} is a colour, so the sweep must name its values", where, sweep.setting));
    if (!sweep.curves_by.empty()) values(where, sweep.curves_by, sweep.curves);
    for (const Expectation& e : sweep.expect) expectation(where, sweep, e);
  }

  void front(const Front& front) {
    const std::string where = fmt::format("front '{}'", front.name);
    common(where, front.ask, front.truth);
    for (const auto& [name, choices] : front.grid) values(where, name, choices);
  }

  void check_all_settings_covered() {
    for (const auto& [name, reason] : plan_.not_measured) {
      known(plan_.step + ": not_measured", name);
      if (!measured_.insert(name).second)
        throw Error(fmt::format("{}: not_measured: {} is measured by a sweep or a front", plan_.step, name));
    }
    for (const SettingSpec& spec : settings_)
      if (!measured_.contains(spec.name))
        throw Error(
            fmt::format("{}: no sweep and no front has the setting {}; add one to measure.json, or give the reason "
                        "under not_measured",
                        plan_.step, spec.name));
  }

 private:
  const SettingSpec& known(const std::string& where, const std::string& name) const {
    std::vector<std::string> names;
    for (const SettingSpec& spec : settings_) {
      if (spec.name == name) return spec;
      names.push_back(spec.name);
    }
    throw Error(fmt::format("{}: {} has no setting '{}'{}", where, plan_.step, name, suggestion(name, names)));
  }

  void value(const std::string& where, const std::string& name, const SettingValue& value) const {
    try {
      Settings(std::vector{known(where, name)}).set(name, value);
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", where, error.what()));
    }
  }

  void values(const std::string& where, const std::string& name, const std::vector<SettingValue>& list) {
    known(where, name);
    for (const SettingValue& each : list) value(where, name, each);
    measured_.insert(name);
  }

  void common(const std::string& where, const Case& ask, const Truth& truth) const {
    for (const auto& [name, each] : ask.settings) value(where + ": settings", name, each);
    for (const auto& [name, each] : truth.settings) value(where + ": truth: settings", name, each);
    if (std::find(outputs_.begin(), outputs_.end(), ask.output) == outputs_.end())
      throw Error(fmt::format("{}: output: '{}' is not allowed; {} offers {}", where, ask.output, plan_.step,
                              fmt::join(outputs_, ", ")));
  }

  void expectation(const std::string& where, const Sweep& sweep, const Expectation& e) const {
    const auto among = [](const std::vector<SettingValue>& list, const std::string& text) {
      return std::any_of(list.begin(), list.end(), [&](const SettingValue& v) { return setting_text(v) == text; });
    };
    const auto all = sweep.values.empty() ? default_values(known(where, sweep.setting)) : sweep.values;
    if (!e.curve.empty() && !among(sweep.curves, e.curve))
      throw Error(fmt::format("{}: expect: curve: there is no curve '{}'", where, e.curve));
    for (const std::string& text : e.values)
      if (!among(all, text)) throw Error(fmt::format("{}: expect: '{}' is not among its values", where, text));
  }

  const Plan& plan_;
  const std::vector<SettingSpec>& settings_;
  const std::vector<std::string>& outputs_;
  std::set<std::string> measured_;
};

/// `count` numbers from low to high in geometric progression.
std::vector<double> geometric_progression(double low, double high, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
    values.push_back(std::min(high, low * std::pow(high / low, double(i) / (count - 1))));  // rounding may exceed high

  return values;
}

}  // namespace

void check_against(const Plan& plan, const std::vector<SettingSpec>& settings,
                   const std::vector<std::string>& outputs) {
  Checker checker(plan, settings, outputs);
  for (const Sweep& sweep : plan.sweeps) checker.sweep(sweep);
  for (const Front& front : plan.fronts) checker.front(front);
  checker.check_all_settings_covered();
}

std::vector<SettingValue> default_values(const SettingSpec& setting) {
  constexpr int count = 9;
  if (std::holds_alternative<bool>(setting.fallback)) return {false, true};
  std::vector<SettingValue> values;
  if (std::holds_alternative<std::string>(setting.fallback)) {
    for (const std::string& choice : setting.choices) values.emplace_back(choice);
    return values;
  }
  if (std::holds_alternative<Colour>(setting.fallback)) return values;
  const bool whole = std::holds_alternative<int>(setting.fallback);
  std::vector<double> numbers;
  double low = setting.low;
  if (low <= 0) {
    numbers.push_back(0);
    low = whole ? 1 : setting.high * 1e-6;
  }
  if (low < setting.high)
    for (const double number : geometric_progression(low, setting.high, count))
      numbers.push_back(whole ? std::round(number) : number);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());  // rounding may give duplicates
  for (const double number : numbers) {
    if (whole)
      values.emplace_back(int(number));
    else
      values.emplace_back(number);
  }
  return values;
}

}  // namespace atelier::measure
