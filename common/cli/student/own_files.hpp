// Prepares a student's own files: builds the C++ and puts them first in the search path.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "cli/search_path.hpp"
#include "grade/zip.hpp"
#include "judge/run/build.hpp"
#include "judge/run/runner.hpp"

namespace atelier {

struct OwnFiles {
  judge::Built built;    ///< of the step itself; if not ok there is nothing to run
  Owners earlier;        ///< whose code is used for the earlier steps
  Implementations path;  ///< for the step's program
};

/// The student's code: steps/, or another folder of NN-name folders, whose libraries are kept apart. Removes libraries
/// of such folders that were not used for a day.
grade::Code own_code(const ProjectFolders& folders, const std::filesystem::path& sources = {});

/// Builds NN-name below `mine.sources` and the earlier steps that it uses, if they are the student's. `earlier` as for
/// choose_owners. Throws Error if an earlier step of the student does not build, with the compiler's output and a
/// workaround.
OwnFiles prepare_own_files(const ProjectFolders& folders, const std::vector<CourseStep>& course, const CourseStep& step,
                           const grade::Code& mine, const std::string& earlier);

/// How the step's program draws a student's cases, with its solution if that is there.
judge::RunSettings run_settings(const ProjectFolders& folders, const CourseStep& step, Implementations path,
                                const std::string& context);

/// The student's files of a step for submission: "NN-name/FILE". Throws Error naming one that is missing, not a regular
/// file or larger than judge::source_limit, which `grade` would reject.
grade::PackedFiles read_own_files(const ProjectFolders& folders, const CourseStep& step);

}  // namespace atelier
