// Whole-value hypotheses: one simple operation that turns the right numbers of a probe into those that came back.
#pragma once

#include <optional>
#include <vector>

#include "judge/compare/judged_case.hpp"
#include "judge/explain/hypotheses.hpp"

namespace atelier::judge {

/// The operation that explains every wrong value of a probe, or none. A value is a matrix (matrix_side() says when
/// numbers are one), or all numbers of an input. Tried are
/// - of matrices: transposed, inverse, inverse transpose, a row or column negated, two rows or columns exchanged;
/// - of two to four numbers: one negated, two exchanged, w in front of x or behind z, not normalised, normalised;
/// - of any: negated, times one factor, off by one constant.
///
/// Named is the one that comes nearest. It must fit within the tolerance of the case, and move at least two numbers
/// beyond those that it was read off from: a symmetric matrix is never called transposed. Where several fit equally
/// well, as the transpose and the inverse of a rotation do, the sentence says all. `yours` has the shape of `expected`.
std::optional<Hypothesis> explain_values(const std::vector<Numbers>& yours, const std::vector<Numbers>& expected,
                                         const JudgedCase& c);

}  // namespace atelier::judge
