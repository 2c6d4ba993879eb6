// Whose code a run is made of: the code under judgement for its own step, and for the steps that it stands on the
// student's or the solution's.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "case/implementations.hpp"
#include "cli/layout.hpp"
#include "grade/step_judge.hpp"

namespace atelier {

enum class Owner { mine, solution };
std::string to_string(Owner owner);  ///< "yours", "solution": as reports say it

/// The student's own files at home, and the finished ones.
grade::Code code_of(const ProjectFolders& folders, Owner owner);

/// Whether this owner has code for the step: a release may come without solutions.
bool is_there(const ProjectFolders& folders, const std::string& step, Owner owner);

/// By earlier step.
using Owners = std::map<std::string, Owner>;

/// Who stands behind each step that `step` uses: `asked` ("mine" or "solution") where it is there. With an empty
/// `asked`: the student where the last full `check` of that step passed every case with the very files that are there
/// now (cli/student/progress_record.hpp), the solution otherwise, so that nobody is stuck. Throws Error for another
/// word.
Owners choose_owners(const ProjectFolders& folders, const std::vector<CourseStep>& course, const CourseStep& step,
                     const std::string& asked);

/// The search path: what is given with `step`, `code` for `step` alone, then each earlier step's owner, and for every
/// other step whatever is there. Nobody but `code` answers for what a student writes in `step`:
/// who takes a file of his away while it is judged is not given the solution's. Throws Error where a folder has ':' in
/// its path, which parts the folders of a search path.
Implementations search_path(const ProjectFolders& folders, const CourseStep& step, const grade::Code& code,
                            const Owners& earlier);

/// {"01-transforms": "solution", "02-blinn-phong": own_words}: for reports.
std::map<std::string, std::string> in_words(const Owners& earlier, const std::string& step,
                                            const std::string& own_words);

}  // namespace atelier
