// A student's progress: the progress record compared with the current course.
#pragma once

#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "cli/student/progress_record.hpp"

namespace atelier {

/// The progress of one step, for `list`, `progress` and `next`.
struct Standing {
  CourseStep step;
  bool checked = false;             ///< whether there was a full check
  bool passed = false;              ///< whether the last one passed every current case
  bool changed = false;             ///< whether the files were edited since
  double score = 0, best = 0;       ///< points of the last full check, and of the best one
  double max_score = 0;             ///< current points of the step
  int cases_passed = 0, cases = 0;  ///< of the current cases
  int hints = 0;                    ///< hints shown, each level counted
};

Standing standing_of(const ProjectFolders& folders, const CourseStep& step, const ProgressRecord& record);
std::vector<Standing> standings(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                                const ProgressRecord& record);

/// "passed", "34.5/100", "1 of 2 cases" (of a step without points), "not checked yet"; with ", edited since" appended.
std::string in_words(const Standing& standing);

/// The first step that has not passed in full; nullptr if all have. Skips steps without cases (in a release, those that
/// only other steps use).
const Standing* next_step(const std::vector<Standing>& standings);

/// One line about all steps: "00 ✓  01 ✓  02 34.5/100  03 ·", or with + and - if the terminal has no Unicode.
std::string progress_line(const std::vector<Standing>& standings, bool unicode);

}  // namespace atelier
