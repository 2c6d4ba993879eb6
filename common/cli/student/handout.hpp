// Quotes from a step's handout.
#pragma once

#include <string>

#include "cli/layout.hpp"

namespace atelier {

/// The step's goal in one line: the paragraph of handouts/NN-name.md that begins with "Afterwards you can", without
/// markup. The step's title if there is no such paragraph.
std::string goal_of(const ProjectFolders& folders, const CourseStep& step);

/// "handouts/NN-name.md"; empty if there is none.
std::string handout_of(const ProjectFolders& folders, const CourseStep& step);

/// "handouts/NN-name.md, \"Further reading\"" if it has that section, otherwise empty.
std::string further_reading_of(const ProjectFolders& folders, const CourseStep& step);

}  // namespace atelier
