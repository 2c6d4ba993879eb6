#include "judge/compare/choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/strict_json.hpp"
#include "judge/explain/sentences.hpp"

namespace atelier::judge {
namespace {

using strict_json::Json;

/// The metrics that need only a picture and its truth.
constexpr std::array metrics{ErrorMetric::rmse,          ErrorMetric::flip,         ErrorMetric::misclassified,
                             ErrorMetric::distance,      ErrorMetric::degrees,      ErrorMetric::wrong,
                             ErrorMetric::blurred_codes, ErrorMetric::blurred_light};

ErrorMetric metric_named(const Json& value, const std::string& where) {
  std::vector<std::string> names;
  for (const ErrorMetric metric : metrics) names.push_back(to_string(metric));
  const std::string name = strict_json::one_of(value, where, names);
  return *std::find_if(metrics.begin(), metrics.end(), [&](ErrorMetric m) { return to_string(m) == name; });
}

Counts read_limits(const Json& object, const std::string& where) {
  if (!object.is_object() || object.empty())
    strict_json::refuse(object, where, "an object with a limit for at least one count: {\"vertices\": 400}");
  Counts limits;
  for (const auto& [name, most] : object.items())
    limits[name] = strict_json::integer(most, where + ": " + name, 1, std::numeric_limits<int>::max());
  return limits;
}

/// "The root mean square error is 0.012"
std::string error_words(ErrorMetric metric, double error) {
  switch (metric) {
    case ErrorMetric::flip:
      return fmt::format("The mean FLIP error is {:.3g}", error);
    case ErrorMetric::misclassified:
      return fmt::format("The fraction of wrong pixels is {:.3g}", error);
    case ErrorMetric::distance:
      return fmt::format("The distance from the truth is {:.3g}, in the unit of the picture", error);
    case ErrorMetric::degrees:
      return fmt::format("The angle to the truth is {:.3g} degrees", error);
    case ErrorMetric::wrong:
      return fmt::format("The fraction of pixels that are wrongly lit or wrongly dark is {:.3g}", error);
    case ErrorMetric::blurred_codes:
      return fmt::format("The root mean square error of the codes, blurred by 2 pixels, is {:.3g}", error);
    case ErrorMetric::blurred_light:
      return fmt::format("The root mean square error of the light, blurred by 2 pixels, is {:.3g}", error);
    default:
      return fmt::format("The root mean square error is {:.3g}", error);
  }
}

}  // namespace

Choice read_choice(const Json& object, const std::string& where) {
  strict_json::refuse_unknown(object, {"settings", "at_most", "error", "full", "none"}, where);
  const auto member = [&](const char* name) -> const Json& { return strict_json::required(object, name, where); };
  Choice choice;
  choice.settings = strict_json::names(member("settings"), where + ": settings", "._");
  if (choice.settings.empty()) throw Error(where + ": settings: there must be at least one setting to choose");
  choice.at_most = read_limits(member("at_most"), where + ": at_most");
  choice.metric = metric_named(member("error"), where + ": error");
  choice.full = strict_json::number(member("full"), where + ": full", 1e-12, 1e12);
  choice.none = strict_json::number(member("none"), where + ": none", 1e-12, 1e12);
  if (choice.none <= choice.full)
    throw Error(fmt::format("{}: none {} must be above full {}", where, choice.none, choice.full));
  return choice;
}

ChoiceMeasurement measure_choice(const Image& picture, const Image& truth, Encoding encoding, const Counts& counts,
                                 const Choice& choice) {
  ChoiceMeasurement measured;
  for (const auto& [name, most] : choice.at_most) {
    const auto count = counts.find(name);
    if (count == counts.end()) throw Error(fmt::format("at_most: the program does not count {}", name));
    const double budget_use = double(count->second) / double(most);
    if (!measured.critical_count.empty() && budget_use <= measured.budget_use) continue;
    measured.critical_count = name;
    measured.budget_use = budget_use;
  }
  measured.error = error_of(picture, truth, choice.metric, encoding);
  if (measured.budget_use > 1) return measured;
  measured.credit = measured.error <= choice.full
                        ? 1
                        : std::max(0.0, std::log(choice.none / measured.error) / std::log(choice.none / choice.full));
  return measured;
}

std::vector<double> exceeded(const ChoiceMeasurement& measured, const Counts& counts, const Choice& choice) {
  std::vector<double> all{measured.error > choice.full ? 1.0 : 0.0};
  for (const auto& [name, most] : choice.at_most) all.push_back(counts.at(name) > most ? 1.0 : 0.0);
  return all;
}

double margin(const ChoiceMeasurement& measured, const Choice& choice) {
  return std::max(measured.error / choice.full, measured.budget_use);
}

std::string describe_choice(const ChoiceMeasurement& measured, const Counts& counts, const Choice& choice) {
  std::string text = fmt::format("{} (all points up to {:.3g}, none from {:.3g}).",
                                 error_words(choice.metric, measured.error), choice.full, choice.none);
  for (const auto& [name, most] : choice.at_most) {
    const std::int64_t count = counts.at(name);
    text += count > most ? fmt::format(" {}: {}, but at most {} are allowed, so there are no points.", name,
                                       grouped(count), grouped(most))
                         : fmt::format(" {}: {} of at most {}.", name, grouped(count), grouped(most));
  }
  return text;
}

}  // namespace atelier::judge
