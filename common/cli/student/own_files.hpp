// A student's own files at home, made ready to run: built where they are C++, and put in front of the search path.
#pragma once

#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "cli/search_path.hpp"
#include "grade/zip.hpp"
#include "judge/run/build.hpp"

namespace atelier {

struct OwnFiles {
  judge::Built built;    ///< of the step itself; where not ok there is nothing to run
  Owners earlier;        ///< who stands behind the steps before
  Implementations path;  ///< for the step's program
};

/// Builds NN-name below `mine.sources` and, where they are the student's, the earlier steps that it uses. `earlier` as
/// for choose_owners. Throws Error where an earlier step of the student's does not build, with the compiler's words and
/// the way round it.
OwnFiles prepare_own_files(const ProjectFolders& folders, const std::vector<CourseStep>& course, const CourseStep& step,
                           const grade::Code& mine, const std::string& earlier);

/// The student's files of a step as they are handed in: "NN-name/FILE". Throws Error naming one that is missing, no
/// regular file or larger than judge::source_limit: `grade` would not take it.
grade::PackedFiles read_own_files(const ProjectFolders& folders, const CourseStep& step);

}  // namespace atelier
