// Matches a picture with its nearest reference, for the verdicts on pictures and on choices.
#pragma once

#include <vector>

#include "judge/compare/gate.hpp"
#include "judge/compare/measure.hpp"
#include "judge/compare/verdict_parts.hpp"

namespace atelier::judge {

/// An answer and its nearest reference.
struct Match {
  const Image* reference_raw = nullptr;
  Image yours, reference;  // in compared form
  Measurement measured;
};

Match best_match(const JudgedCase& c, const Image& yours_raw, const std::vector<Image>& references);

/// Moves both pictures and their difference into the result, for the report.
void keep_evidence(CaseResult& result, Match& match, const JudgedCase& c);

/// Completes the result of a picture that failed at the gate. Names the recognised mistake of a single-colour picture.
void report_gate_failure(CaseResult& result, const GateFailure& stopped, const JudgedCase& c, const Image& yours,
                         const StepReferences& references, KeepEvidence keep);

}  // namespace atelier::judge
