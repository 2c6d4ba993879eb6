// Results as plots.
#pragma once

#include "measure/plot.hpp"
#include "measure/tables.hpp"

namespace atelier::measure {

/// Error against the swept value: a curve for each value of the second setting, the fitted power dashed over the range
/// that it was fitted to, the noise floor dotted. Without anything that depends on the machine's speed.
Plot chart_of_errors(const SweepResult& result);

/// Error against the time of a frame, every point with the spread of its times. Nothing where times were not taken.
std::optional<Plot> chart_of_times(const SweepResult& result);

/// All points of a front, its Pareto front as a line, the knee ringed. Nothing where times were not taken.
std::optional<Plot> chart_of_front(const FrontResult& result);

}  // namespace atelier::measure
