// A student's own files of one step, from the files as they lie there to a verdict: once for `check`, at every save for
// `watch`.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "grade/step_judge.hpp"

namespace atelier {

struct OwnCheckOptions {
  std::vector<std::string> cases;  ///< only these; empty: all
  std::string context;             ///< "osmesa", "egl", "window", or empty: the first of them that is there
  std::string earlier;             ///< "mine", "solution", or empty: yours where it has passed
  std::filesystem::path sources;   ///< where the own NN-name/ folders are; empty: steps/
  bool live = false;               ///< compare with what the solution draws on the same driver
};

class OwnCheck {
 public:
  /// Reads the step's cases and the record of progress. Throws Error where either is broken.
  OwnCheck(const ProjectFolders& folders, std::vector<CourseStep> course, CourseStep step, OwnCheckOptions options);

  /// Builds, draws and judges the files as they are now; references are read meanwhile, and once. Throws Error where
  /// the course's own side is at fault, and judge::Interrupted where `interrupted` says so.
  judge::StepResult judge(const std::function<bool()>& interrupted = {});

  /// Whether verdicts say how far the student is: of the own files, and of every case.
  bool counts_as_progress() const { return options_.cases.empty() && options_.sources.empty(); }

  /// Takes the last verdict down in progress.json, unless it does not count or the files were edited meanwhile: it is
  /// then about a text that is nowhere any more.
  void record(const judge::StepResult& result) const;

  const CourseStep& step() const { return step_; }
  const ProjectFolders& folders() const { return folders_; }
  const std::vector<CourseStep>& course() const { return course_; }

 private:
  judge::RunSettings run_settings(Implementations path) const;

  ProjectFolders folders_;
  std::vector<CourseStep> course_;
  CourseStep step_;
  OwnCheckOptions options_;
  grade::StepJudge judge_;
  bool live_drawn_ = false;
  std::string judged_files_;  ///< digest of what the last verdict is about
};

/// The folder of a step's report, unless the student says otherwise: out/check/NN-name.
std::filesystem::path own_report_folder(const ProjectFolders& folders, const std::string& step);

/// Writes preview.png (yours, the reference and the difference of the first case that fails, or of the first), then
/// results.json and report.html.
void write_own_report(judge::SubmissionResult& result, const std::filesystem::path& folder);

}  // namespace atelier
