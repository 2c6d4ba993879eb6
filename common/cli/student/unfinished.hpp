// Earlier steps of a student's that are not finished and that no solution stands in for.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/search_path.hpp"

namespace atelier {

/// The steps in `owners` whose code is the student's and has not passed in full as it is now, each with its state in
/// words: "untouched", "34.5/100", "passed, edited since", "not checked yet", "without cases here". Throws Error if the
/// progress record is invalid.
std::map<std::string, std::string> unfinished_steps(const ProjectFolders& folders,
                                                    const std::vector<CourseStep>& course, const Owners& owners);

/// What a student must read before the points of `step`: which steps are unfinished, that the points therefore do not
/// judge `step` alone, and what to do. Empty if `unfinished` is.
std::string about_unfinished(const ProjectFolders& folders, const CourseStep& step,
                             const std::map<std::string, std::string>& unfinished);

}  // namespace atelier
