// Grades submissions one after the other, each in a sandbox of its own.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "cli/layout.hpp"
#include "grade/intake/submission.hpp"
#include "grade/step_judge.hpp"
#include "judge/compare/result.hpp"
#include "sandbox/tier.hpp"

namespace atelier {

struct GraderSettings {
  std::string context;                   ///< "osmesa", "egl", "window", or empty: the first available one
  int workers = 2;                       ///< programs that draw at the same time, 1..64
  std::optional<std::uint64_t> shuffle;  ///< seed of a random order of the cases; none: as listed
  sandbox::Tier tier = sandbox::Tier::none;
  std::filesystem::path more_cases;                     ///< folder of a grader's own NN-name/cases.json; empty: none
  std::optional<std::chrono::milliseconds> case_limit;  ///< wall-clock time of one case; none: the default
};

/// Called while a submission is graded.
struct GraderEvents {
  std::function<bool()> interrupted;                                                  ///< true: stop
  std::function<void(const std::string& step)> building;                              ///< a step's files are compiled
  std::function<void(const std::string& step, std::size_t k, std::size_t n)> judged;  ///< k of n cases are
  std::function<void(const judge::StepResult& step)> finished;
};

class SubmissionGrader {
 public:
  /// For these steps. Reads all cases and references now, so that a broken one stops everything before anything is
  /// graded. Throws Error for that, if an earlier step's solution is missing, and if this machine cannot draw.
  SubmissionGrader(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                   const std::vector<CourseStep>& steps, const GraderSettings& settings);

  /// The result of each of the grader's steps, also of those that are not handed in, with numbers drawn from `seed`
  /// (grade/varied_cases.hpp) where there is a solution. Throws judge::Interrupted if the event says so, and Error only
  /// for problems that are not the student's.
  judge::SubmissionResult grade(const grade::Submission& submission, std::uint64_t seed,
                                const GraderEvents& events) const;

  const judge::StepFlags& flags() const { return flags_; }
  const judge::Environment& environment() const { return environment_; }

 private:
  judge::StepResult grade_step(const grade::Submission& submission, const CourseStep& step,
                               const grade::StepJudge& judge, std::uint64_t seed, const GraderEvents& events) const;
  judge::StepResult grade_built(const CourseStep& step, const grade::StepJudge& judge,
                                const judge::RunSettings& settings, std::uint64_t seed,
                                const GraderEvents& events) const;
  judge::RunSettings run_settings(const grade::Code& code, const CourseStep& step) const;
  Implementations public_search_path(const CourseStep& step, const grade::Code& code) const;
  void publish_earlier_steps();
  void add_more_cases();

  ProjectFolders folders_;
  std::vector<CourseStep> course_, steps_;
  judge::StepFlags flags_;
  GraderSettings settings_;
  judge::Environment environment_;
  std::deque<grade::StepJudge> judges_;  ///< of steps_, in order
  TemporaryFolder solution_shaders_;     ///< the driver's cache for solutions, which no student's program can reach
  TemporaryFolder published_;            ///< earlier steps' solutions as later steps use them: NN-name/FILE
};

}  // namespace atelier
