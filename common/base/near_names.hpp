// "Did you mean ...?": the known name that the user most likely meant.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace atelier {

/// The smallest number of single-letter insertions, deletions, replacements and swaps of neighbours that turn `a` into
/// `b`, editing no letter twice (optimal string alignment distance; Damerau 1964, Wagner and Fischer 1974). Takes time
/// proportional to the product of the lengths.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known name nearest to `name`, the first if several are. Empty if more than a third of the letters (at least one)
/// must be edited: a wrong suggestion is worse than none.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// The end of an error message about an unknown name: "; did you mean 'x'?" if a name is near, otherwise
/// "; known are a, b, c", or "; there are none".
std::string suggestion(std::string_view name, const std::vector<std::string>& known);

/// "a, b, c"
std::string join(const std::vector<std::string>& words, std::string_view separator = ", ");

}  // namespace atelier
