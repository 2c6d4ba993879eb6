// From the points of the cases to grades: the rules of course.toml, applied to what grading has recorded.
#pragma once

#include <string>
#include <vector>

#include "grade/course/course_file.hpp"
#include "grade/results/record.hpp"

namespace atelier::grade {

/// Points are rounded down to hundredths, as in all reports: less than everything never looks like everything.
struct StepGrade {
  std::string step;
  StepRecord::State state = StepRecord::State::not_handed_in;
  double points = 0;      ///< after scaling, bonus and penalty; rounded
  double max_points = 0;  ///< without bonus
  double penalty = 0;     ///< points taken off for being late; rounded
  int days_late = 0;      ///< started days after the deadline; 0: in time, or nothing to be late with
};

struct Grade {
  std::vector<StepGrade> steps;  ///< those that count, sorted by name
  double points = 0;             ///< the sum before its parts were rounded, then the adjustment; rounded; at least 0
  double max_points = 0;
  double adjustment = 0;  ///< a person's, from comments.csv
  bool late = false;      ///< a step is, by its deadline; where no deadline can decide it, as the platform marks it
  std::vector<std::string> needs_human;  ///< the record's, and why these rules cannot decide
};

/// A step's counting cases earn rules.points in proportion, or their own points; bonus cases earn by the same scale and
/// come on top. A step handed in later than deadline + grace loses percent_per_day of what it earned for each started
/// day after the deadline, and everything after `days` of them. Steps that are not handed in are not late. If the time
/// is not known, nothing is taken off, and a platform's mark of lateness needs a person.
Grade grade_of(const SubmissionRecord& record, const CourseFile& course, double adjustment = 0);

/// The index of the version that counts, of several of one student, oldest first (at least one): the last, or the one
/// with most points, of equal ones the last.
std::size_t counting_version(const std::vector<SubmissionRecord>& versions, const CourseFile& course);

/// Down to hundredths; 0.29, whose floating-point value is slightly smaller, stays.
double rounded_points(double points);

}  // namespace atelier::grade
