// What to do after a step has passed.
#pragma once

#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "cli/student/standing.hpp"

namespace atelier {

/// A few lines for a step that has just passed in full: further reading in the handout, how to compare with the
/// solution (if it can be read here), and the next step. Empty for a step that does not exist or has not passed.
std::string after_pass(const ProjectFolders& folders, const std::vector<Standing>& standings, const std::string& step);

}  // namespace atelier
