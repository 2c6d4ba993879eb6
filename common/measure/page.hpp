// All measurements of a step on one HTML page.
#pragma once

#include <string>

#include "measure/tables.hpp"

namespace atelier::measure {

/// A self-contained HTML file: for each front and sweep its plots, its fits, what theory expects and whether it was
/// met, and a table of numbers. Throws Error if gnuplot is missing.
std::string page(const StepMeasured& measured);

}  // namespace atelier::measure
