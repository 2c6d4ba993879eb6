// The progress of a long command, on stderr, so that stdout has only the results.
#pragma once

#include <cstdio>
#include <string>

#include "judge/compare/result.hpp"

namespace atelier {

/// On a terminal one line that is overwritten, and erased at the end; otherwise (a file, a pipe, TERM=dumb) a line for
/// each finished step.
class Progress {
 public:
  /// For a number of `steps`. `terminal`: `out` can overwrite a line, which gets fewer than `width` columns.
  Progress(std::FILE* out, bool terminal, int width, std::size_t steps);
  /// Writes to stderr; detects whether that is a terminal, and its width.
  explicit Progress(std::size_t steps);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void building(const std::string& step);                              ///< "01-transforms: building (step 2 of 3)"
  void judged(const std::string& step, std::size_t k, std::size_t n);  ///< "01-transforms: case 3 of 14 (step 2 of 3)"
  void finished(const judge::StepResult& step);  ///< "01-transforms: 12 / 14 points, 13 of 14 cases passed (...)"
  void clear();                                  ///< erases the line on a terminal

 private:
  void rewrite(const std::string& text);
  std::string with_place(const std::string& text) const;

  std::FILE* out_;
  bool terminal_;
  int width_;
  std::size_t steps_, place_ = 1;
};

}  // namespace atelier
