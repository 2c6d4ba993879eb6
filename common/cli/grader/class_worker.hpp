// A process that grades submissions of a class, one after the other, until none is left.
//
// Several work on one class, on this machine or on others, and nobody hands out the work: each takes the next
// submission without a record of this plan whose folder it can lock. The lock ends with the process, so a submission
// whose process was killed is taken by another, and a record is written whole and last, so no verdict is lost.
#pragma once

#include <filesystem>
#include <string>

#include "cli/grader/class_plan.hpp"

namespace atelier {

/// Whether the submission has a record of this plan; `plan_written` is the time of the plan's file.
bool is_graded(const ClassPlaces& places, const std::string& id, std::filesystem::file_time_type plan_written);

/// A record in place of a verdict: nothing was judged, and a person must look at it.
void record_failure(const ClassPlaces& places, const ClassPlan& plan, const grade::HandedIn& handed_in,
                    const std::string& why);

struct GradeWorkerOptions {
  std::filesystem::path out;  ///< folder of the class's results
  int index = 0, of = 1;      ///< begins with every of-th submission from this one, then takes what is left
};

/// The hidden command ./atelier grade-worker. Returns exit_ok once nothing is left that it can take. Throws Error for
/// problems with the project, which concern all submissions.
int run_grade_worker(const GradeWorkerOptions& options);

}  // namespace atelier
