// Other forms of a solution with the same meaning.
#pragma once

#include <string_view>
#include <vector>

#include "cli/author/edits.hpp"

namespace atelier {

/// Changes of form in what a student writes of a marked solution: operands exchanged, comparisons turned round, a - b
/// as a + (-b), a / b as a product (GLSL), normalize(v) as v / length(v) (GLSL), x += y written out, guards in another
/// form, results in a temporary (C++). Any of them that do not overlap may be made together.
std::vector<Edit> rewritings_of(std::string_view marked, bool glsl);

}  // namespace atelier
