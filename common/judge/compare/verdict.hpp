// One case, one answer: is it right, and if not, what does it look like?
#pragma once

#include "judge/compare/answer.hpp"
#include "judge/compare/judged_case.hpp"
#include "judge/compare/references.hpp"
#include "judge/compare/result.hpp"

namespace atelier::judge {

/// Which results carry pictures for a report: three float pictures, 3 MB for 256x256.
enum class KeepEvidence { never, failures, always };

/// The whole verdict, in this order:
/// 1. nothing came back (missing, crashed, timeout, build failed): no points, and the program's own sentence;
/// 2. gate 0 (gate.hpp): another size, values that are not finite, a single colour: no points;
/// 3. the profile against each accepted reference, of which the best counts: passed gives all points;
/// 4. hypotheses on the whole answer (hypotheses.hpp, value_hypotheses.hpp), then the known mistakes of the step
///    (naming.hpp), whose name is given beside a hypothesis too;
/// 5. partial credit (credit.hpp), the sentence, the worst pixel, the pictures.
/// Steps 4 and 5 cost nothing to those who pass. The FLIP map is left out: draw_flip() adds it when a report is drawn.
/// Throws Error where a reference is missing or broken, whatever the answer was.
CaseResult judge_case(const JudgedCase& c, const Answer& answer, const StepReferences& references,
                      KeepEvidence keep = KeepEvidence::failures);

/// Adds the FLIP map and "flip_mean" to a result that has pictures of colours and lacks them.
void draw_flip(CaseResult& result);

}  // namespace atelier::judge
