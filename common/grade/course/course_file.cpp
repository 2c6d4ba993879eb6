#include "grade/course/course_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "grade/course/toml_value.hpp"

namespace atelier::grade {
namespace {

using Field = GradebookColumn::Field;
using TomlKind = TomlValue::Kind;

const std::vector<std::string> names_of_tier_rules = {"counts", "bonus", "ignored"};
const std::vector<std::string> names_of_attempts = {"last", "best"};
const std::vector<std::string> names_of_feedback = {"full", "where", "score"};
const std::vector<std::pair<std::string, Field>> names_of_fields = {
    {"student", Field::student}, {"id", Field::id},           {"identifier", Field::identifier},
    {"total", Field::total},     {"late", Field::late},       {"needs_human", Field::needs_human},
    {"report", Field::report},   {"comment", Field::comment}, {"adjustment", Field::adjustment}};

/// Reads values of one file; an error names the file, the line and the key.
class CourseReader {
 public:
  CourseReader(const std::filesystem::path& file, const std::vector<std::string>& known_steps)
      : file_(printable(file.string())), known_steps_(known_steps) {}

  CourseFile read(const TomlValue& document) const;

 private:
  [[noreturn]] void refuse(const TomlValue& value, const std::string& allowed) const {
    const std::string text = shorten(printable(value.text), 80);
    throw Error(fmt::format("{}:{}: {}: {} is not allowed; it takes {}", file_, value.line, shown_key(value),
                            value.kind == TomlKind::text ? "'" + text + "'" : text, allowed));
  }
  [[noreturn]] void fail(const TomlValue& value, const std::string& why) const {
    throw Error(fmt::format("{}:{}: {}: {}", file_, value.line, shown_key(value), why));
  }
  static std::string shown_key(const TomlValue& value) { return shorten(printable(value.key), 80); }

  /// The members of a table; refuses those that are not in `known`.
  const std::vector<TomlValue>& members(const TomlValue& table, const std::vector<std::string>& known) const {
    for (const TomlValue& member : any_members(table))
      if (std::find(known.begin(), known.end(), member.key) == known.end())
        throw Error(fmt::format("{}:{}: unknown key '{}'{}", file_, member.line, shown_key(member),
                                suggestion(member.key, known)));
    return table.elements;
  }
  const std::vector<TomlValue>& any_members(const TomlValue& table) const {
    if (table.kind != TomlKind::table) refuse(table, fmt::format("a table, [{}]", shown_key(table)));
    return table.elements;
  }

  std::string line_of_text(const TomlValue& value) const {
    const bool good = value.kind == TomlKind::text && !value.text.empty() && value.text.size() <= 200 &&
                      printable(value.text) == value.text;
    if (!good) refuse(value, "a text in quotes: one line, 1..200 bytes, without control characters");
    return value.text;
  }
  double number(const TomlValue& value, double low, double high) const {
    const bool good = (value.kind == TomlKind::integer || value.kind == TomlKind::number) && value.number >= low &&
                      value.number <= high;
    if (!good) refuse(value, fmt::format("a number {}..{}", low, high));
    return value.number;
  }
  int integer(const TomlValue& value, int low, int high) const {
    if (value.kind != TomlKind::integer || value.number < low || value.number > high)
      refuse(value, fmt::format("a whole number {}..{}", low, high));
    return int(value.number);
  }
  /// The index of the value in `choices`.
  std::size_t one_of(const TomlValue& value, const std::vector<std::string>& choices) const {
    const auto found = std::find(choices.begin(), choices.end(), value.text);
    if (value.kind != TomlKind::text || found == choices.end()) refuse(value, "\"" + join(choices, "\", \"") + "\"");
    return std::size_t(found - choices.begin());
  }

  void read_late(const TomlValue& table, LatePenalty& late) const;
  void read_tiers(const TomlValue& table, std::map<std::string, TierRule>& tiers) const;
  StepRules read_step(const TomlValue& table) const;
  void read_steps(const TomlValue& table, CourseFile& course) const;
  GradebookColumn read_column(const TomlValue& value, const CourseFile& course) const;
  void read_gradebook(const TomlValue& table, CourseFile& course) const;
  void read_naming(const TomlValue& table, CourseFile& course) const;

  std::string file_;
  const std::vector<std::string>& known_steps_;
};

void CourseReader::read_late(const TomlValue& table, LatePenalty& late) const {
  for (const TomlValue& value : members(table, {"percent_per_day", "grace_minutes", "days"})) {
    if (value.key == "percent_per_day") late.percent_per_day = number(value, 0, 100);
    if (value.key == "grace_minutes") late.grace_minutes = integer(value, 0, 10080);
    if (value.key == "days") late.days = integer(value, 0, 365);
  }
}

void CourseReader::read_tiers(const TomlValue& table, std::map<std::string, TierRule>& tiers) const {
  for (const TomlValue& value : members(table, {"core", "further", "challenge"}))
    tiers[value.key] = TierRule(one_of(value, names_of_tier_rules));
  if (std::none_of(tiers.begin(), tiers.end(), [](const auto& tier) { return tier.second == TierRule::counts; }))
    fail(table, "no tier counts, so nobody could earn points; let at least one be \"counts\"");
}

StepRules CourseReader::read_step(const TomlValue& table) const {
  StepRules rules{.step = table.key};
  if (std::find(known_steps_.begin(), known_steps_.end(), table.key) == known_steps_.end())
    throw Error(fmt::format("{}:{}: there is no step '{}'{}", file_, table.line, shown_key(table),
                            suggestion(table.key, known_steps_)));
  for (const TomlValue& value : members(table, {"points", "deadline"})) {
    if (value.key == "points") rules.points = number(value, 0, 10000);
    if (value.key == "deadline") {
      if (!value.moment) refuse(value, "a date with time and offset, without quotes, such as 2026-11-02T23:59:00+01:00");
      rules.deadline = value.moment;
      rules.deadline_text = value.text;
    }
  }
  return rules;
}

void CourseReader::read_steps(const TomlValue& table, CourseFile& course) const {
  for (const TomlValue& step : any_members(table)) course.steps.push_back(read_step(step));
  if (course.steps.empty()) fail(table, "lists no step; leave the table out, and all steps count");
  std::sort(course.steps.begin(), course.steps.end(), [](const auto& a, const auto& b) { return a.step < b.step; });
}

GradebookColumn CourseReader::read_column(const TomlValue& value, const CourseFile& course) const {
  GradebookColumn column{.heading = value.key};
  if (value.key.empty() || value.key.size() > 200 || printable(value.key) != value.key)
    fail(value, "a heading is one line of 1..200 bytes, without control characters");
  const std::string field = line_of_text(value);
  for (const auto& [name, known] : names_of_fields)
    if (field == name) column.field = known;
  if (column.field != Field::text) return column;
  if (field.starts_with("text:")) {
    column.argument = field.substr(5);
    return column;
  }
  column.field = Field::step;
  column.argument = field.starts_with("step:") ? field.substr(5) : "";
  std::vector<std::string> counting;
  for (const std::string& step : known_steps_)
    if (course.counts(step)) counting.push_back(step);
  if (std::find(counting.begin(), counting.end(), column.argument) != counting.end()) return column;
  if (field.starts_with("step:"))
    fail(value, fmt::format("'{}' is no step that counts{}", shorten(column.argument, 80),
                            suggestion(column.argument, counting)));
  std::vector<std::string> names;
  for (const auto& [name, known] : names_of_fields) names.push_back(name);
  names.insert(names.end(), {"step:NN-name", "text:ANY TEXT"});
  const std::string near = nearest_name(field, names);
  refuse(value, join(names) + (near.empty() ? "" : "; did you mean '" + near + "'?"));
}

void CourseReader::read_gradebook(const TomlValue& table, CourseFile& course) const {
  for (const TomlValue& value : members(table, {"columns", "byte_order_mark"})) {
    if (value.key == "byte_order_mark") {
      if (value.kind != TomlKind::boolean) refuse(value, "true or false");
      course.byte_order_mark = value.number != 0;
      continue;
    }
    for (const TomlValue& column : any_members(value)) course.columns.push_back(read_column(column, course));
    if (course.columns.empty()) fail(value, "has no column; leave the table out for the usual ones");
  }
}

void CourseReader::read_naming(const TomlValue& table, CourseFile& course) const {
  for (const TomlValue& value : members(table, {"pattern"})) {
    course.naming = line_of_text(value);
    try {
      const std::regex pattern(course.naming);
      if (pattern.mark_count() < 1 || pattern.mark_count() > 2)
        refuse(value, "one or two groups in parentheses: the name, then the identifier; write (?:...) for others");
    } catch (const std::regex_error&) {
      refuse(value, "a regular expression (ECMAScript), such as '([^_]+)_([0-9]+)_.*'");
    }
  }
}

CourseFile CourseReader::read(const TomlValue& document) const {
  CourseFile course;
  members(document, {"title", "attempts", "feedback", "tiers", "late", "steps", "gradebook", "naming", "limits"});
  // Columns may name steps, so the steps are read before them.
  if (const TomlValue* steps = document.find("steps")) read_steps(*steps, course);
  for (const TomlValue& value : document.elements) {
    if (value.key == "title") course.title = line_of_text(value);
    if (value.key == "attempts") course.attempts = Attempts(one_of(value, names_of_attempts));
    if (value.key == "feedback") course.feedback = Feedback(one_of(value, names_of_feedback));
    if (value.key == "tiers") read_tiers(value, course.tiers);
    if (value.key == "late") read_late(value, course.late);
    if (value.key == "gradebook") read_gradebook(value, course);
    if (value.key == "naming") read_naming(value, course);
    if (value.key == "limits")
      for (const TomlValue& limit : members(value, {"seconds"})) course.seconds = number(limit, 1, 600);
  }
  return course;
}

}  // namespace

const StepRules* CourseFile::rules(std::string_view step) const {
  for (const StepRules& each : steps)
    if (each.step == step) return &each;
  return nullptr;
}

CourseFile read_course_file(const std::filesystem::path& file, const std::vector<std::string>& known_steps) {
  const std::string text = read_file(file, 1 << 20);
  return CourseReader(file, known_steps).read(parse_toml(text, printable(file.string())));
}

std::string to_string(TierRule rule) {
  return names_of_tier_rules[std::size_t(rule)];
}
std::string to_string(Attempts attempts) {
  return names_of_attempts[std::size_t(attempts)];
}
std::string to_string(Feedback feedback) {
  return names_of_feedback[std::size_t(feedback)];
}

}  // namespace atelier::grade
