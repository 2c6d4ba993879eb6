// Small changes of a solution that another mistake may look like.
#pragma once

#include <string_view>
#include <vector>

#include "cli/author/edits.hpp"

namespace atelier {

/// All single changes of this kind in what a student writes of a marked solution: a sign turned, an operator or a
/// comparison exchanged, a constant changed, arguments, swizzles or matrices exchanged, a term, a factor, a call, a
/// statement or a guard left out, min for max, sine for cosine, one OpenGL enum for its sibling. Some of them change
/// nothing, and some do not compile.
std::vector<Edit> mutations_of(std::string_view marked);

}  // namespace atelier
