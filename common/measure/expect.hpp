// Whether what was measured is what theory says. Errors and orders only: times are never judged.
#pragma once

#include <string>
#include <vector>

#include "measure/sweep.hpp"

namespace atelier::measure {

/// One expectation against one curve.
struct Finding {
  bool met = false;
  std::string words;  ///< "hall-segments: slope -2.01, expected -2 +- 0.2 (4 .. 512)"
  std::string reason;
};

/// Every expectation of a sweep, for every curve that it is about.
std::vector<Finding> findings(const SweepResult& result);

/// The power that fits a curve above its own noise floor, within the range of the sweep's own expectation of a slope
/// where it has one. Nothing where the swept values are no numbers, or too few points are left.
std::optional<Fit> fit_of(const SweepResult& result, const std::string& curve);

}  // namespace atelier::measure
