// The verdict on one answer: whether it is right, and if not, what is wrong.
#pragma once

#include "judge/compare/answer.hpp"
#include "judge/compare/judged_case.hpp"
#include "judge/compare/references.hpp"
#include "judge/compare/result.hpp"

namespace atelier::judge {

/// Which results keep pictures for a report: three float pictures, 3 MB for 256x256.
enum class KeepEvidence { never, failures, always };

/// The whole verdict, in this order:
/// 1. no answer (missing, crashed, timeout, build failed): no points, and the program's message;
/// 2. the gate (gate.hpp): wrong size, values that are not finite, a single colour: no points;
/// 3. comparison by the profile with each accepted reference; the best counts; all points if it passes;
/// 4. hypotheses about the whole answer (hypotheses.hpp, value_hypotheses.hpp), then the known mistakes of the step
///    (naming.hpp), which are named in addition to a hypothesis;
/// 5. partial credit (credit.hpp), the sentence, the worst pixel, the pictures.
/// Steps 4 and 5 run only if the answer fails. draw_flip() adds the FLIP map later, when a report is written.
/// Throws Error if a reference is missing or broken, whatever the answer is.
CaseResult judge_case(const JudgedCase& c, const Answer& answer, const StepReferences& references,
                      KeepEvidence keep = KeepEvidence::failures);

/// Adds the FLIP map and "flip_mean" to a result with colour pictures, if it lacks them.
void draw_flip(CaseResult& result);

}  // namespace atelier::judge
