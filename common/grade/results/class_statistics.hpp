// What the records of a class say together.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "grade/results/class_results.hpp"

namespace atelier::grade {

/// How the points of a step are distributed among those who handed it in.
struct StepStatistics {
  std::string step, title;
  double max_points = 0;       ///< the most that anybody could earn without bonus
  std::array<int, 11> bins{};  ///< by share of max_points: 0-10 % ... 90-100 %, and everything or more
  int handed_in = 0;           ///< with any change, whether it compiles or not
  int not_built = 0;           ///< of these
  int untouched = 0, absent = 0;
  double median = 0, mean = 0;  ///< points of those who handed it in; 0 if nobody did
};

/// A mistake that was recognised in submissions.
struct MistakeStatistics {
  std::string step, mistake;
  std::string title, sentence;            ///< of mistakes.json; empty: it is not there
  std::vector<const ClassRow*> students;  ///< sorted by id
  int cases = 0;                          ///< of all of them
};

/// Students for whom a person is needed for one reason.
struct HumanReason {
  std::string reason;
  std::vector<const ClassRow*> students;  ///< sorted by id
};

struct ClassStatistics {
  std::vector<StepStatistics> steps;        ///< as results.steps
  std::vector<MistakeStatistics> mistakes;  ///< made by most students first
  std::vector<HumanReason> needs_human;     ///< rare reasons first: one that all share is seldom about a student
  std::vector<const ClassRow*> slowest;     ///< at most 5, those with most work first; none without times
  std::vector<std::pair<std::string, int>> sandboxes;  ///< tier and number of submissions, sorted by name
};

/// Refers to rows of `results`, which must live longer.
ClassStatistics class_statistics(const ClassResults& results);

/// The grade of a step in a row; nullptr: it has none.
const StepGrade* step_grade(const ClassRow& row, const std::string& step);

}  // namespace atelier::grade
