// The ground truth on the command line: pictures from the oracle instead of OpenGL. No context is opened.
#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>

#include "app/step_program.hpp"

namespace atelier {

/// Traces a picture case with n x n samples a pixel; long work shows its progress. Throws Error where a scene, a
/// setting or an output is unknown, or has no ground truth.
Image trace_case(const StepProgram& program, const Case& picture, int samples);

/// Writes DIR/NAME.pixels for each picture of a file of cases, and DIR/NAME.error where there is no truth: so also for
/// probes, whose numbers have their truth in the case. `progress` as for answer_cases.
void trace_cases(const StepProgram& program, const std::filesystem::path& cases, const std::filesystem::path& folder,
                 int samples, std::optional<int> progress);

/// A bar that grows in one line of a terminal: shown once the work has taken two seconds, and taken away in the end.
/// Where `out` is no terminal nothing is ever written.
class ProgressBar {
 public:
  ProgressBar(std::FILE* out, bool terminal, double patience_s = 2);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(double done);  ///< 0..1

 private:
  std::FILE* out_;
  bool terminal_;
  double patience_s_, began_s_;
  int shown_ = -1;  ///< percent; -1: nothing stands there
};

}  // namespace atelier
