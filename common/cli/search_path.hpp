// Whose code a run uses: the judged code for its own step, and the student's or the solution's for earlier steps.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "case/implementations.hpp"
#include "cli/layout.hpp"
#include "grade/step_judge.hpp"

namespace atelier {

enum class Owner { mine, solution };
std::string to_string(Owner owner);  ///< "yours", "solution": for reports

/// The folders of the student's code, or of the solutions.
grade::Code code_of(const ProjectFolders& folders, Owner owner);

/// Whether this owner has code for the step that runs here: a release may have no solutions, or libraries for machines
/// of another kind.
bool is_there(const ProjectFolders& folders, const std::string& step, Owner owner);

/// Whether the step's solution is here as text: a release has none, or a compiled one, unless it was made with
/// `--earlier source`.
bool is_solution_readable(const ProjectFolders& folders, const CourseStep& step);

/// Owners by earlier step.
using Owners = std::map<std::string, Owner>;

/// The owner of the code for each step that `step` uses, as `asked`: "mine" or "solution". If `asked` is empty: the
/// student if the last full `check` of that step passed every case and its files have not changed since
/// (cli/student/progress_record.hpp), otherwise the solution, or the student where there is none. Throws Error for
/// another `asked`, and for a solution that is asked for and not there.
Owners choose_owners(const ProjectFolders& folders, const std::vector<CourseStep>& course, const CourseStep& step,
                     const std::string& asked);

/// The search path: the given code of `step`, `code` for `step` only, then each earlier step's owner, and for every
/// other step whatever exists. The student's files of `step` come only from `code`, so a missing file is never replaced
/// by the solution's. Throws Error if a folder has ':', the separator of search paths, in its path.
Implementations search_path(const ProjectFolders& folders, const CourseStep& step, const grade::Code& code,
                            const Owners& earlier);

/// {"01-transforms": "solution", "02-blinn-phong": own_words}: for reports.
std::map<std::string, std::string> in_words(const Owners& earlier, const std::string& step,
                                            const std::string& own_words);

}  // namespace atelier
