// What a step must have beside working code. The commands that make these files check them, so that an author sees
// problems before the full tests.
//
// Each sentence names the file and what to add.
#pragma once

#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "measure/tables.hpp"

namespace atelier {

using Problems = std::vector<std::string>;

/// Printed by ./atelier skeleton. For a step with C++: a test that unused features cost nothing, and for each function
/// in a case a group of extremes in tests/stability/NN-name/, or a comment there that names it and says why there is
/// none. Empty if there are no tests, as in a release.
Problems problems_of_tests(const ProjectFolders& folders, const CourseStep& step);

/// Printed by ./atelier reference: two hints for every function in a case (cli/student/hints.hpp); a handout that names
/// each case that has points and is not hidden, and has the points of each tier in its table.
Problems problems_of_cases(const ProjectFolders& folders, const CourseStep& step);

/// Also printed by ./atelier reference, for the pictures among these cases: the reference must be the ground truth (by
/// `agreement`), or the case must say in truth_differs why not.
Problems problems_of_truth(const ProjectFolders& folders, const CourseStep& step,
                           const std::vector<std::string>& cases);

/// Printed by ./atelier audit: mistakes and variants must have their texts, and each mistake a second spelling.
Problems problems_of_mistakes(const ProjectFolders& folders, const CourseStep& step);

/// Printed by ./atelier measure after all of a step was measured: two sweeps with a slope of the error, an expectation
/// for each sweep, a sweep for the handout and its plot there.
Problems problems_of_measured(const ProjectFolders& folders, const measure::StepMeasured& measured);

/// "! SENTENCE" in lines, to be printed.
std::string in_lines(const Problems& problems);

}  // namespace atelier
