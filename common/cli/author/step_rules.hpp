// What a step must have beside code that works, held against its files by the command that makes the thing: so that an
// author is told at once, and not by the full tests.
//
// Each sentence names the file and what to add.
#pragma once

#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "measure/tables.hpp"

namespace atelier {

using Lacks = std::vector<std::string>;

/// Told by ./atelier skeleton. Of a step with C++: a test of what a scene requires, and for each function that a case
/// names a group of extremes in tests/stability/NN-name/, or there a comment that names it and says why there is none.
/// Nothing where there are no tests, as in a release.
Lacks lacks_of_tests(const ProjectFolders& folders, const CourseStep& step);

/// Told by ./atelier reference: two hints for every function that a case names (cli/student/hints.hpp); a handout that
/// names each case with points which is not hidden, and has the points of each tier in its table.
Lacks lacks_of_cases(const ProjectFolders& folders, const CourseStep& step);

/// Told by ./atelier reference, too, of the pictures among these cases: the reference is the ground truth (to
/// `agreement`), or the case says in truth_differs why it is not.
Lacks lacks_of_truth(const ProjectFolders& folders, const CourseStep& step, const std::vector<std::string>& cases);

/// Told by ./atelier audit: mistakes and variants, their words written, and of each mistake a second spelling.
Lacks lacks_of_mistakes(const ProjectFolders& folders, const CourseStep& step);

/// Told by ./atelier measure where all of a step was measured: two sweeps whose errors have a slope, something expected
/// of each sweep, a sweep for the handout, its plot there.
Lacks lacks_of_measured(const ProjectFolders& folders, const measure::StepMeasured& measured);

/// "! SENTENCE" in lines, to be printed.
std::string in_lines(const Lacks& lacks);

}  // namespace atelier
