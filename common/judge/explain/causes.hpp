// What a whole step's answers say together: which function to correct first, which failing cases only wait for it, and
// which known mistakes agree with all answers. One answer alone cannot tell: many mistakes look alike in a picture.
#pragma once

#include <vector>

#include "judge/compare/judged_case.hpp"
#include "judge/compare/references.hpp"
#include "judge/compare/result.hpp"

namespace atelier::judge {

/// A mistake is not named from a picture with fewer failing pixels.
inline constexpr int min_failing_pixels = 16;

/// Sets step.causes and, of its failing cases, `waits_for`, the mistake's name with its sentence and hint, and the hint
/// of cases that wait. step.cases[i] is the verdict on cases[i].
///
/// A probe asks the first of its case's functions. A function is wrong if one of its probes fails although no other
/// function that this probe needs (CaseReferences::needs) is wrong. A failing case waits for the first wrong function
/// that it needs, in the order in which probes ask functions first; functions as in the skeleton come last.
///
/// A mistake is named if it is the only one that the answer could be and that no other answer contradicts: each probe
/// that it would change returns its numbers, and no picture that it would change passes. A case that waits is named
/// only if a probe has returned the mistake's numbers. Probes as in the skeleton are not named.
void explain_step(StepResult& step, const std::vector<JudgedCase>& cases, const StepReferences& references);

}  // namespace atelier::judge
