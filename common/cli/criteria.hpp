// What a step of this project is judged with.
#pragma once

#include "cli/layout.hpp"
#include "grade/step_judge.hpp"

namespace atelier {

grade::Criteria criteria_of(const ProjectFolders& folders, const CourseStep& step);

}  // namespace atelier
