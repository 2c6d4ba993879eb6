// Whole-value hypotheses: one simple operation that turns the expected numbers of a probe into the returned ones.
#pragma once

#include <optional>
#include <vector>

#include "judge/compare/judged_case.hpp"
#include "judge/explain/hypotheses.hpp"

namespace atelier::judge {

/// The operation that explains every wrong value of a probe, or nothing. A value is a matrix (see matrix_side()) or all
/// numbers of an input. Tested are
/// - for matrices: transposed, inverse, inverse transpose, a row or column negated, two rows or columns exchanged;
/// - for two to four numbers: one negated, two exchanged, w first or last, not normalised, normalised;
/// - for any numbers: negated, multiplied by a factor, shifted by a constant.
///
/// Returns the best fit. It must fit within the tolerance of the case and change at least two numbers beyond those that
/// its parameter was derived from, so a symmetric matrix is never called transposed. If several fit equally well, as
/// the transpose and the inverse of a rotation do, the sentence names all. `yours` has the shape of `expected`.
std::optional<Hypothesis> explain_values(const std::vector<Numbers>& yours, const std::vector<Numbers>& expected,
                                         const JudgedCase& c);

}  // namespace atelier::judge
