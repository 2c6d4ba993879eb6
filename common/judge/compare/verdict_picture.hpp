// Matches a picture with its nearest reference, for the verdicts on pictures and on choices.
#pragma once

#include <vector>

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

/// Whether there is a picture, and it passes the gate. Otherwise the result is complete.
bool is_comparable(CaseResult& result, const JudgedCase& c, const Answer& answer, const StepReferences& references,
                   KeepEvidence keep);

}  // namespace atelier::judge
