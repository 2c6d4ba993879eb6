// How far a student is: the progress record held against the course as it is now.
#pragma once

#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "cli/student/progress_record.hpp"

namespace atelier {

/// One step, as `list`, `progress` and `next` show it.
struct Standing {
  CourseStep step;
  bool checked = false;             ///< whether there was a full check
  bool passed = false;              ///< whether the last one passed every case that the step has now
  bool changed = false;             ///< whether the files were edited since
  double score = 0, best = 0;       ///< points of the last full check, and of the best one
  double max_score = 0;             ///< points that the step has now
  int cases_passed = 0, cases = 0;  ///< of those that the step has now
  int hints = 0;                    ///< hints shown, each level counted
};

Standing standing_of(const ProjectFolders& folders, const CourseStep& step, const ProgressRecord& record);
std::vector<Standing> standings(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                                const ProgressRecord& record);

/// "passed", "34.5/100", "1 of 2 cases" (of a step without points), "not checked yet"; ", edited since" behind.
std::string in_words(const Standing& standing);

/// The first step that has not passed in full; nullptr where all have. A step without cases (in a release, one that
/// others stand on) is passed over.
const Standing* next_step(const std::vector<Standing>& standings);

/// One line about all steps: "00 ✓  01 ✓  02 34.5/100  03 ·", or with + and - where the terminal has no unicode.
std::string progress_line(const std::vector<Standing>& standings, bool unicode);

}  // namespace atelier
