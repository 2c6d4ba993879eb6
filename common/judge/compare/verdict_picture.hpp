// A picture beside the reference that it comes nearest to: what verdicts on pictures and on choices rest on.
#pragma once

#include <vector>

#include "judge/compare/gate.hpp"
#include "judge/compare/measure.hpp"
#include "judge/compare/verdict_parts.hpp"

namespace atelier::judge {

/// An answer with the reference that it comes nearest to.
struct Match {
  const Image* reference_raw = nullptr;
  Image yours, reference;  // in compared form
  Measurement measured;
};

Match best_match(const JudgedCase& c, const Image& yours_raw, const std::vector<Image>& references);

/// Keeps both pictures and where they differ for the report.
void keep_evidence(CaseResult& result, Match& match, const JudgedCase& c);

/// A picture that did not come through gate 0: what is there is shown, and its mistake named where many look like it.
void stop_at_gate(CaseResult& result, const GateFailure& stopped, const JudgedCase& c, const Image& yours,
                  const StepReferences& references, KeepEvidence keep);

}  // namespace atelier::judge
