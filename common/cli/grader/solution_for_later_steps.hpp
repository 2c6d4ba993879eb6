// A step's solution in the form in which later steps use it, and which no student reads by accident.
#pragma once

#include <map>
#include <string>

#include "cli/layout.hpp"

namespace atelier {

/// The files by name: libstep.so without debug information, and each shader sealed (base/sealed.hpp). No choices.txt,
/// which no later step reads. In a release these are the files that it has. Throws Error if the library has not been
/// built.
std::map<std::string, std::string> solution_for_later_steps(const ProjectFolders& folders, const CourseStep& step);

}  // namespace atelier
