// One step in the HTML report.
#pragma once

#include <string>

#include "judge/report/report_words.hpp"

namespace atelier::judge {

/// A step in the order of the terminal's report: its points, the compiler's output, what to correct (the first cause
/// open, with its pictures above its words; the others folded), and last the cases that passed, folded unless there is
/// nothing else to see. Every case is there once, under its anchor.
std::string step_html(const StepResult& step, StepsInReport steps);

/// The id of a step's section.
std::string step_anchor(const StepResult& step);

}  // namespace atelier::judge
