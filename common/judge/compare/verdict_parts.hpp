// What the verdicts on pictures, choices and probes have in common.
#pragma once

#include <string>

#include "judge/compare/answer.hpp"
#include "judge/compare/credit.hpp"
#include "judge/compare/verdict.hpp"
#include "judge/explain/hypotheses.hpp"

namespace atelier::judge {

/// All points; nothing to try.
void pass(CaseResult& result);

/// Partial credit, with its explanation where there is any.
void give(CaseResult& result, const Credit& credit);

/// No answer was written, or no usable one.
void miss(CaseResult& result, const Answer& answer);

/// The name of a known mistake, with its sentence and its hint.
void name_mistake(CaseResult& result, const std::string& name, const StepReferences& references);

/// Puts a hypothesis in front of what was seen.
void say_hypothesis(CaseResult& result, const Hypothesis& whole);

/// Each completes a blank result for an answer that the program ended normally.
CaseResult judge_picture(CaseResult result, const JudgedCase& c, const Answer& answer, const StepReferences& references,
                         KeepEvidence keep);
CaseResult judge_choice(CaseResult result, const JudgedCase& c, const Answer& answer, const StepReferences& references,
                        KeepEvidence keep);
CaseResult judge_probe(CaseResult result, const JudgedCase& c, const Answer& answer, const StepReferences& references);

/// Why a result has no answer: the program's own words, or a sentence for the status.
std::string reason_without_answer(Status status, const Answer& answer);

}  // namespace atelier::judge
