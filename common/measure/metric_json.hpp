// The name of an error metric in a measurement plan.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "base/strict_json.hpp"
#include "image/error.hpp"

namespace atelier::measure {

/// Throws Error with `where`, the value and the names that are allowed.
inline ErrorMetric metric_from_json(const strict_json::Json& value, const std::string& where) {
  std::vector<std::string> names;
  for (const ErrorMetric known : error_metrics) names.push_back(to_string(known));
  const std::string chosen = strict_json::one_of(value, where, names);
  return error_metrics[std::size_t(std::ranges::find(names, chosen) - names.begin())];
}

}  // namespace atelier::measure
