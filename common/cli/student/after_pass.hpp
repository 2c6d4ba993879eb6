// What to do once a step has passed.
#pragma once

#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "cli/student/standing.hpp"

namespace atelier {

/// A few lines for a step that has just passed in full: where the handout says more, how to see the solution beside
/// one's own (where solutions/ is there), and which step is next. Empty for a step that is not there or has not passed.
std::string after_pass(const ProjectFolders& folders, const std::vector<Standing>& standings, const std::string& step);

}  // namespace atelier
