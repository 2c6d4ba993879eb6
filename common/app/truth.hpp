// --truth: pictures from the oracle instead of OpenGL. No context is created.
#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>

#include "app/step_program.hpp"

namespace atelier {

/// Traces a picture case with n x n samples per pixel; shows progress if it takes long. Throws Error if a scene, a
/// setting or an output is unknown or has no ground truth.
Image trace_case(const StepProgram& program, const Case& picture, int samples);

/// Writes DIR/NAME.pixels for each picture of a file of cases, and DIR/NAME.error if there is no truth, so also for
/// probes (the case itself has their expected values). `progress` as for answer_cases.
void trace_cases(const StepProgram& program, const std::filesystem::path& cases, const std::filesystem::path& folder,
                 int samples, std::optional<int> progress);

/// A progress bar on one line of a terminal: appears after two seconds and is erased at the end. Writes nothing if
/// `out` is not a terminal.
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
  int shown_ = -1;  ///< percent; -1: not shown
};

}  // namespace atelier
