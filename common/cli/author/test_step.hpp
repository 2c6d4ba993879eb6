// All that must hold of one step: ./atelier test --step NN.
#pragma once

#include "cli/author/test_tally.hpp"
#include "cli/layout.hpp"

namespace atelier {

/// Runs, topic by topic, the tests of tests/steps/ that go through all steps, with this step alone, those that are
/// about it, and its table of extremes. Prints a line for each topic, and all that was said where one fails.
Tally test_step(const ProjectFolders& folders, const CourseStep& step);

}  // namespace atelier
