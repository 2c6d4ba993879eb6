// Asks a step program for a judge's cases; fills in the student's choices first.
#pragma once

#include <string>
#include <vector>

#include "judge/compare/judged_case.hpp"
#include "judge/run/runner.hpp"

namespace atelier::judge {

/// Like run_cases: one answer per case, in order. A case with a choice gets the settings of NN-name/choices.txt on the
/// search path of `settings`, and its cost is counted. It is drawn with settings.solution if that is set, so that the
/// student's code cannot influence the cost. If the file or a choice is invalid, the answer's error says why.
std::vector<Answer> ask_cases(const RunSettings& settings, const std::string& step,
                              const std::vector<JudgedCase>& cases, const OnAnswer& on_answer = {});

/// What a program is asked for a case: with the settings of NN-name/choices.txt if it has a choice. Throws Error if the
/// file or a choice is invalid.
Case ask_of(const RunSettings& settings, const std::string& step, const JudgedCase& c);

/// The ground truths of the cases with a choice, from the oracle; for other cases an answer without pixels.
std::vector<Answer> ask_truths(const RunSettings& settings, const std::vector<JudgedCase>& cases);

}  // namespace atelier::judge
