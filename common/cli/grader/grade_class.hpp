// Grades a class: finds its submissions, grades each in a process of its own, and writes gradebook and reports.
#pragma once

#include "cli/commands.hpp"

namespace atelier {

/// What run_grade does for a class. Results are in options.out, which must be named. Returns exit_ok once all are
/// graded, whatever the points. Throws Error for bad options, a broken project, and if another process grades into the
/// same folder.
int run_grade_class(const GradeOptions& options);

}  // namespace atelier
