// Functions shared by the verdicts on pictures, choices and probes.
#pragma once

#include <string>

#include "judge/compare/answer.hpp"
#include "judge/compare/credit.hpp"
#include "judge/compare/verdict.hpp"
#include "judge/explain/hypotheses.hpp"

namespace atelier::judge {

/// Sets the status to passed, with all points and without a hint.
void give_full_credit(CaseResult& result);

/// Sets the partial credit and its explanation.
void give_partial_credit(CaseResult& result, const Credit& credit);

/// Sets the status to missing: there is no usable answer.
void set_missing(CaseResult& result, const Answer& answer);

/// Sets the name of the recognised mistake, with its sentence and hint.
void name_mistake(CaseResult& result, const std::string& name, const StepReferences& references);

/// Puts the hypothesis's sentence before the reason, and uses its hint.
void add_hypothesis(CaseResult& result, const Hypothesis& whole);

/// Each completes a blank result for an answer that ended normally.
CaseResult judge_picture(CaseResult result, const JudgedCase& c, const Answer& answer, const StepReferences& references,
                         KeepEvidence keep);
CaseResult judge_choice(CaseResult result, const JudgedCase& c, const Answer& answer, const StepReferences& references,
                        KeepEvidence keep);
CaseResult judge_probe(CaseResult result, const JudgedCase& c, const Answer& answer, const StepReferences& references);

/// The status of an answer that is not judged yet: failed if it ended normally.
Status status_of(Answer::Ended ended);

/// Why there is no answer: the program's message, or a sentence for the status.
std::string reason_without_answer(Status status, const Answer& answer);

}  // namespace atelier::judge
