// Builds and judges a student's files of one step: once for `check`, at every save for `watch`.
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
  std::string context;             ///< "osmesa", "egl", "window", or empty: the first available one
  std::string earlier;             ///< "mine", "solution", or empty: yours if it has passed
  std::filesystem::path sources;   ///< the folder of the student's NN-name/ folders; empty: steps/
  bool live = false;               ///< compare with the solution's pictures on the same driver
};

class OwnCheck {
 public:
  /// Reads the step's cases and the progress record. Throws Error if either is invalid.
  OwnCheck(const ProjectFolders& folders, std::vector<CourseStep> course, CourseStep step, OwnCheckOptions options);

  /// Builds, draws and judges the current files; reads references once, in parallel. Throws Error for errors of the
  /// course's own files, and judge::Interrupted if `interrupted` returns true.
  judge::StepResult judge(const std::function<bool()>& interrupted = {});

  /// Whether verdicts count as progress: for the student's own files, and every case.
  bool counts_as_progress() const { return options_.cases.empty() && options_.sources.empty(); }

  /// Records the last verdict in progress.json, unless it does not count or the files were edited meanwhile.
  void record(const judge::StepResult& result) const;

  const CourseStep& step() const { return step_; }
  const ProjectFolders& folders() const { return folders_; }
  const std::vector<CourseStep>& course() const { return course_; }

 private:
  ProjectFolders folders_;
  std::vector<CourseStep> course_;
  CourseStep step_;
  OwnCheckOptions options_;
  grade::StepJudge judge_;
  bool live_drawn_ = false;
  std::string judged_files_;  ///< hash of the files of the last verdict
};

/// The default folder of a step's report: out/check/NN-name.
std::filesystem::path own_report_folder(const ProjectFolders& folders, const std::string& step);

/// Writes preview.png (yours, the reference and the difference of the first case that fails, or of the first), then
/// results.json and report.html.
void write_own_report(judge::SubmissionResult& result, const std::filesystem::path& folder);

}  // namespace atelier
