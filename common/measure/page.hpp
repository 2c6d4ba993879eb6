// Everything that was measured on one page.
#pragma once

#include <string>

#include "measure/tables.hpp"

namespace atelier::measure {

/// One HTML file that needs nothing beside it: for each front and each sweep its plots, its fits, what theory expects
/// and whether it was met, and a table of numbers. Throws Error where gnuplot is missing.
std::string page(const StepMeasured& measured);

}  // namespace atelier::measure
