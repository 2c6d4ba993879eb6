// The tests of one step: ./atelier test --step NN.
#pragma once

#include "cli/author/test_tally.hpp"
#include "cli/layout.hpp"

namespace atelier {

/// Runs, topic by topic, the tests of tests/steps/ that apply to each step, only for this step, those tagged with it,
/// and its table of extremes. Prints a line for each topic, and the output of failed ones.
Tally test_step(const ProjectFolders& folders, const CourseStep& step);

}  // namespace atelier
