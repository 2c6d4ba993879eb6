// Asks a step program for cases as the judge knows them: what a student has chosen is filled in first.
#pragma once

#include <string>
#include <vector>

#include "judge/compare/judged_case.hpp"
#include "judge/run/runner.hpp"

namespace atelier::judge {

/// As run_cases, one answer a case in their order. A case with a choice is asked with what NN-name/choices.txt on the
/// search path of `settings` says, is counted, and is drawn by the code of settings.solution where that is known: the
/// student's own program has then no say in what it costs. Where the file or a choice cannot be
/// taken, the answer says why, and nothing is drawn.
std::vector<Answer> ask_cases(const RunSettings& settings, const std::string& step,
                              const std::vector<JudgedCase>& cases, const OnAnswer& on_answer = {});

/// The truths of those cases that have one to be compared with, drawn by the oracle; answers without pixels elsewhere.
std::vector<Answer> ask_truths(const RunSettings& settings, const std::vector<JudgedCase>& cases);

}  // namespace atelier::judge
