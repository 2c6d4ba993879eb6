// Compares measured errors and their order with theory. Times are never judged.
#pragma once

#include <string>
#include <vector>

#include "measure/sweep.hpp"

namespace atelier::measure {

/// One expectation against one curve.
struct Finding {
  bool met = false;
  std::string words;  ///< "hall-segments: slope -2.010 from 4 to 512, expected -2 +- 0.2"
  std::string reason;
};

/// Checks every expectation of a sweep on every curve that it applies to.
std::vector<Finding> findings(const SweepResult& result);

/// Fits a power law to a curve above its noise floor, within the range of the sweep's slope expectation if it has one.
/// Nothing if the swept values are not numbers or too few points remain.
std::optional<Fit> fit_of(const SweepResult& result, const std::string& curve);

}  // namespace atelier::measure
