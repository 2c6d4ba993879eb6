// Budget cases: the student chooses settings, and is judged by the error that is left at a bounded cost.
//
// The truth that the picture is compared with comes from the oracle and is stored with the case, so the judge traces
// nothing. The cost is counted work (vertices, texture bytes, lights), never time: it is the same on every machine.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "image/error.hpp"

namespace atelier::judge {

/// Counts by the names that a step program's --stats gives them.
using Counts = std::map<std::string, std::int64_t>;

/// What may be chosen, and what an error is worth.
struct Choice {
  std::vector<std::string> cases;     ///< all budget cases of the step, this one among them: whom choices.txt may name
  std::vector<std::string> settings;  ///< the names that may be set
  Counts at_most;                     ///< what the picture may cost; above it there are no points
  ErrorMetric metric = ErrorMetric::rmse;
  double full = 0;  ///< all points up to this error
  double none = 0;  ///< no points from this error on; full < none
};

/// All but `cases` from {"settings": [...], "at_most": {"vertices": 400}, "error": "rmse", "full": 0.01, "none": 0.1}.
/// Throws Error naming the member, the value and what is allowed.
Choice read_choice(const nlohmann::json& object, const std::string& where);

/// How good a choice is.
struct ChoiceMeasurement {
  double error = 0;
  std::string dearest;  ///< the count that takes most of what it may
  double spent = 0;     ///< what it takes, as a multiple of what it may; above 1: too dear
  double credit = 0;    ///< 0..1 of the points: by the logarithm of the error between `full` and `none`
  bool passed() const { return credit == 1; }
};

/// `picture` and `truth` of one size and finite. Throws Error where a count that is limited was not made.
ChoiceMeasurement measure_choice(const Image& picture, const Image& truth, Encoding encoding, const Counts& counts,
                                 const Choice& choice);

/// How many tolerances away a choice lies, as for pictures: the larger of error / full and `spent`.
double margin(const ChoiceMeasurement& measured, const Choice& choice);

/// "The root mean square error is 0.012 (all points up to 0.01, none from 0.1). vertices: 132 of at most 400."
std::string describe_choice(const ChoiceMeasurement& measured, const Counts& counts, const Choice& choice);

}  // namespace atelier::judge
