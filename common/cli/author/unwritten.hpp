// Solutions in which some functions are still as in the skeleton.
#pragma once

#include <set>
#include <string>

namespace atelier {

/// The marked text with the definitions of these functions as in the skeleton; a name that it does not define is
/// ignored. `file` is its name in errors, `step` is used in the TODO lines. Throws Error as cut_skeleton does.
std::string with_unwritten(std::string marked, const std::set<std::string>& functions, const std::string& file,
                           const std::string& step);

}  // namespace atelier
