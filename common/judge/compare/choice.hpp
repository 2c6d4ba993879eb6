// Budget cases: the student chooses settings; the picture's error counts, and its cost must not exceed a limit.
//
// The truth that the picture is compared with was traced by the oracle and is stored with the case. The cost is counted
// work (vertices, texture bytes, lights), never time, so it is the same on every machine.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "image/error.hpp"

namespace atelier::judge {

/// Counts by name, from a step program's --stats.
using Counts = std::map<std::string, std::int64_t>;

/// The settings that may be chosen, the limits on cost, and the points for an error.
struct Choice {
  std::vector<std::string> cases;     ///< all budget cases of the step, including this one: choices.txt may name these
  std::vector<std::string> settings;  ///< the names that may be set
  Counts at_most;                     ///< the picture's cost limits; above one there are no points
  ErrorMetric metric = ErrorMetric::rmse;
  double full = 0;  ///< all points up to this error
  double none = 0;  ///< no points from this error on; full < none
};

/// Reads {"settings": [...], "at_most": {"vertices": 400}, "error": "rmse", "full": 0.01, "none": 0.1}; leaves `cases`
/// empty. Throws Error naming the member, the value and what is allowed.
Choice read_choice(const nlohmann::json& object, const std::string& where);

struct ChoiceMeasurement {
  double error = 0;
  std::string critical_count;  ///< the count that is largest relative to its limit
  double budget_use = 0;       ///< that count / its limit; above 1: too expensive
  double credit = 0;           ///< fraction of the points: logarithmic in the error between `full` and `none`
  bool passed() const { return credit == 1; }
};

/// `picture` and `truth` must have the same size and be finite. Throws Error if a limited count is missing.
ChoiceMeasurement measure_choice(const Image& picture, const Image& truth, Encoding encoding, const Counts& counts,
                                 const Choice& choice);

/// What is exceeded, 0 or 1 each: the error for all points, then the limits by name. A known mistake is recognised by
/// it.
std::vector<double> exceeded(const ChoiceMeasurement& measured, const Counts& counts, const Choice& choice);

/// The distance in tolerances, as for pictures: the larger of error / full and `budget_use`.
double margin(const ChoiceMeasurement& measured, const Choice& choice);

/// "The root mean square error is 0.012 (all points up to 0.01, none from 0.1). vertices: 132 of at most 400."
std::string describe_choice(const ChoiceMeasurement& measured, const Counts& counts, const Choice& choice);

}  // namespace atelier::judge
