// The progress of grading a class, on stderr.
#pragma once

#include <cstdio>
#include <string>

#include "base/stopwatch.hpp"
#include "cli/grader/class_plan.hpp"

namespace atelier {

/// On a terminal one line, "112 of 300 graded, 4 need a person, about 41 min left"; otherwise such a line at each
/// tenth.
class ClassProgress {
 public:
  ClassProgress(const ClassPlaces& places, const ClassPlan& plan);
  ~ClassProgress();
  void show();           ///< as often as one likes
  void stopped() const;  ///< says how far it has come, and that it can go on

 private:
  std::string words(std::size_t graded, std::size_t need_human) const;

  const ClassPlaces& places_;
  const ClassPlan& plan_;
  Stopwatch since_;
  Stopwatch since_shown_;
  bool terminal_;
  std::size_t at_begin_ = 0;            ///< graded when this began
  std::size_t last_ = std::size_t(-1);  ///< graded when a line was printed last
};

/// "45 s", "12 min", "3 h 05 min".
std::string duration_words(double seconds);

}  // namespace atelier
