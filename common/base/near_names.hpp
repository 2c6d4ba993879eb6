// "Did you mean ...?": the known name that somebody most likely wanted to type.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace atelier {

/// The least number of single-letter insertions, deletions, replacements and swaps of neighbours that turn `a` into
/// `b`, no letter being edited twice (the optimal string alignment distance; Damerau 1964, Wagner and Fischer 1974).
/// Time is the product of the lengths.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known name nearest to `name`, the first of several; empty where none is within a third of its letters (at least
/// one edit), because a far-fetched suggestion misleads more than none.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// The end of an error sentence about an unknown name: "; did you mean 'x'?" where a name is near, otherwise
/// "; known are a, b, c", or "; there are none".
std::string suggestion(std::string_view name, const std::vector<std::string>& known);

/// "a, b, c"
std::string join(const std::vector<std::string>& words, std::string_view separator = ", ");

}  // namespace atelier
