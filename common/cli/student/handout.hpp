// What the commands quote from a step's handout.
#pragma once

#include <string>

#include "cli/layout.hpp"

namespace atelier {

/// What a student can do after the step, as one line: the paragraph of handouts/NN-name.md that begins with "Afterwards
/// you can", without its emphasis. The step's title where there is no such paragraph.
std::string goal_of(const ProjectFolders& folders, const CourseStep& step);

/// "handouts/NN-name.md"; empty where there is none.
std::string handout_of(const ProjectFolders& folders, const CourseStep& step);

/// "handouts/NN-name.md, \"Further reading\"" where it has that section; empty where not.
std::string further_reading_of(const ProjectFolders& folders, const CourseStep& step);

}  // namespace atelier
