// Results as plots.
#pragma once

#include "measure/plot.hpp"
#include "measure/tables.hpp"

namespace atelier::measure {

/// Error, or the count, against the swept value: a curve for each value of the second setting, the fitted power laws as
/// dashed lines, the noise floor as a dotted line. Nothing in it depends on the machine's speed.
Plot chart_of_errors(const SweepResult& result);

/// Error against the time of a frame, with the range of times of each point; if the plan measures a count, the time
/// against the swept value. Nothing if times were not measured.
std::optional<Plot> chart_of_times(const SweepResult& result);

/// All points, the Pareto front as a line, a ring around the knee. Nothing if times were not measured.
std::optional<Plot> chart_of_front(const FrontResult& result);

}  // namespace atelier::measure
