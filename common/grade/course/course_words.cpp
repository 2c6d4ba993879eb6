#include "grade/course/course_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/near_names.hpp"

namespace atelier::grade {
namespace {

using Field = GradebookColumn::Field;

std::string line(const char* label, const std::string& text) {
  return fmt::format("{:<12}{}\n", label, text);
}

std::string late_words(const LatePenalty& late) {
  std::string words =
      late.percent_per_day > 0 ? fmt::format("{:g} % off for each started day", late.percent_per_day) : "nothing off";
  if (late.grace_minutes > 0) words += fmt::format(", after {} minutes of grace", late.grace_minutes);
  if (late.days) words += fmt::format(", no points after {} {}", *late.days, *late.days == 1 ? "day" : "days");
  return words;
}

std::string tiers_words(const std::map<std::string, TierRule>& tiers) {
  std::vector<std::string> words;
  for (const char* tier : {"core", "further", "challenge"}) words.push_back(tier + (" " + to_string(tiers.at(tier))));
  return join(words);
}

std::string columns_words(const std::vector<GradebookColumn>& columns) {
  if (columns.empty()) return "the usual columns";
  std::vector<std::string> headings;
  for (const GradebookColumn& column : columns) headings.push_back(column.heading);
  return join(headings, " | ");
}

std::string steps_table(const CourseFile& course, const std::map<std::string, std::string>& steps) {
  std::string table = fmt::format("{:<22} {:>10}  {:<26} {}\n", "step", "points", "deadline", "title");
  for (const auto& [name, title] : steps) {
    if (!course.counts(name)) continue;
    const StepRules* const rules = course.rules(name);
    const bool own = rules == nullptr || !rules->points;
    const bool deadline = rules != nullptr && rules->deadline;
    table += fmt::format("{:<22} {:>10}  {:<26} {}\n", name, own ? "of cases" : fmt::format("{:g}", *rules->points),
                         deadline ? rules->deadline_text : "none", title);
  }
  return table;
}

/// Settings that change nothing, because of what else the file says or does not say.
std::vector<std::string> without_effect(const CourseFile& course) {
  std::vector<std::string> notes;
  const bool deadline = std::any_of(course.steps.begin(), course.steps.end(),
                                    [](const auto& rules) { return rules.deadline.has_value(); });
  const bool penalty = course.late.percent_per_day > 0 || course.late.days;
  if (penalty && !deadline) notes.push_back("[late] has no effect: no step has a deadline");
  if (deadline && !penalty) notes.push_back("late steps keep all points: [late] takes nothing off");
  if (course.columns.empty()) return notes;
  const auto has = [&](Field field) {
    return std::any_of(course.columns.begin(), course.columns.end(), [&](const auto& c) { return c.field == field; });
  };
  if (!has(Field::id) && !has(Field::identifier) && !has(Field::student))
    notes.push_back("no column says whose row it is: add one with student, id or identifier");
  if (!has(Field::needs_human)) notes.push_back("no column says which grades need a human; class.html does");
  return notes;
}

}  // namespace

std::string course_in_words(const CourseFile& course, const std::map<std::string, std::string>& steps) {
  std::string words = course.title.empty() ? "" : course.title + "\n\n";
  words += steps_table(course, steps) + "\n";
  words += line("tiers", tiers_words(course.tiers));
  words += line("late", late_words(course.late));
  words += line("attempts", course.attempts == Attempts::last ? "the last one counts" : "the best one counts");
  words += line("feedback", to_string(course.feedback));
  words += line("gradebook", columns_words(course.columns));
  words += line("naming", course.naming.empty() ? "recognised" : course.naming);
  words += line("limits", course.seconds ? fmt::format("{:g} seconds for a case", *course.seconds) : "as in check");
  for (const std::string& note : without_effect(course)) words += "note: " + note + "\n";
  return words;
}

}  // namespace atelier::grade
