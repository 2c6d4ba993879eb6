// The histogram of a step's points in class.html.
#pragma once

#include <string>

#include "grade/results/class_statistics.hpp"

namespace atelier::grade {

/// A picture of the bins (SVG) with a text alternative, and the numbers around it.
std::string histogram_html(const StepStatistics& step);

}  // namespace atelier::grade
