// course.toml: how a course turns the points of cases into grades. docs/course.toml has every setting.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace atelier::grade {

/// A step that counts.
struct StepRules {
  std::string step;                      ///< "02-blinn-phong"
  std::optional<double> points;          ///< for all counting cases, 0..10 000; none: the cases' own points
  std::optional<std::int64_t> deadline;  ///< seconds since 1970, UTC; none: never late
  std::string deadline_text;             ///< as in the file, for people
};

/// What the cases of a tier are worth.
enum class TierRule {
  counts,   ///< they earn points, and the step's points are for them
  bonus,    ///< they earn points above the step's points
  ignored,  ///< they earn none
};

struct LatePenalty {
  double percent_per_day = 0;  ///< 0..100, of the points earned, for each started day after the deadline
  int grace_minutes = 0;       ///< 0..10 080: as late as this is in time
  std::optional<int> days;     ///< 0..365: after this many days there are no points; none: no such limit
};

enum class Attempts { last, best };          ///< which version of a submission counts
enum class Feedback { full, where, score };  ///< what a student's report shows (grade/course/feedback.hpp)

/// A column of the gradebook.
struct GradebookColumn {
  enum class Field {
    student,
    id,
    identifier,
    step,
    total,
    late,
    needs_human,
    report,
    adjustment,
    comment,
    text,  ///< the same in every row
  };
  std::string heading;
  Field field = Field::text;
  std::string argument;  ///< the step's name, or the text
};

struct CourseFile {
  std::string title;             ///< empty: none
  std::vector<StepRules> steps;  ///< sorted by name; empty: all steps count, with the cases' own points
  std::map<std::string, TierRule> tiers{
      {"core", TierRule::counts}, {"further", TierRule::counts}, {"challenge", TierRule::counts}};
  LatePenalty late;
  Attempts attempts = Attempts::last;
  Feedback feedback = Feedback::full;
  std::vector<GradebookColumn> columns;  ///< empty: the default (grade/results/gradebook.hpp)
  bool byte_order_mark = false;          ///< the gradebook begins with one, as some versions of Excel need
  std::string naming;                    ///< see ClassNaming::pattern; empty: recognised
  std::optional<double> seconds;         ///< of drawing allowed for a case, 1..600; none: the default

  /// nullptr: the file has no rules for the step.
  const StepRules* rules(std::string_view step) const;
  /// Whether the step counts: it is listed, or no step is.
  bool counts(std::string_view step) const { return steps.empty() || rules(step) != nullptr; }
};

/// Reads and checks a whole file; `known_steps` are those of the project. Throws Error "FILE:LINE: KEY: ..." with the
/// value and what is allowed: for what is no TOML, unknown keys (with the nearest known one), wrong types, values out
/// of range, steps that the project does not have, columns of steps that do not count, patterns that are none.
CourseFile read_course_file(const std::filesystem::path& file, const std::vector<std::string>& known_steps);

std::string to_string(TierRule rule);      ///< "counts", "bonus", "ignored"
std::string to_string(Attempts attempts);  ///< "last", "best"
std::string to_string(Feedback feedback);  ///< "full", "where", "score"

}  // namespace atelier::grade
