// Records of a class made up for tests.
#pragma once

#include <string>
#include <vector>

#include "grade/results/class_results.hpp"

namespace atelier::test {

/// A step with core points alone.
grade::StepRecord step_record(const std::string& step, double score, double max_score,
                              grade::StepRecord::State state = grade::StepRecord::State::judged);

/// Ada Lovelace with two steps: 7.5 of 10, and 12 of 20 with a mistake.
grade::SubmissionRecord ada();

/// `count` students with twelve steps: with all states, mistakes, lateness, times and reasons for a human; always the
/// same.
std::vector<grade::SubmissionRecord> made_up_class(int count);

grade::ClassSummary made_up_summary();

}  // namespace atelier::test
