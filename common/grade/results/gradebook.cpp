#include "grade/results/gradebook.hpp"

#include <algorithm>
#include <iterator>

#include "base/csv.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::grade {
namespace {

using Field = GradebookColumn::Field;
using judge::points_text;

/// Characters that have no width and direction marks that printable() keeps: they would only hide differences of names.
bool is_invisible(char32_t c) {
  return c == 0x061C || c == 0x200B || c == 0x2060 || c == 0xFEFF;
}

bool begins_formula(std::string_view text) {
  constexpr char32_t signs[] = {U'=', U'+', U'-', U'@', 0xFF1D, 0xFF0B, 0xFF0D, 0xFF20};
  text.remove_prefix(std::min(text.size(), text.find_first_not_of(' ')));
  return !text.empty() &&
         std::find(std::begin(signs), std::end(signs), first_code_point(text).value) != std::end(signs);
}

/// With a sign, as people write it.
std::string adjustment_text(double points) {
  if (points == 0) return "";
  return points < 0 ? "-" + points_text(-points) : points_text(points);
}

bool is_handed_in(StepRecord::State state) {
  return state != StepRecord::State::not_handed_in && state != StepRecord::State::untouched;
}

/// Empty where nothing was handed in: nobody has failed, and a person may have to look.
std::string total_cell(const ClassRow& row) {
  const bool any = std::ranges::any_of(row.grade.steps, [](const StepGrade& step) { return is_handed_in(step.state); });
  return any || row.grade.points > 0 ? points_text(row.grade.points) : "";
}

/// "One; two": sentences may end with a full stop or not.
std::string in_one_line(std::vector<std::string> sentences) {
  for (std::string& sentence : sentences)
    if (sentence.ends_with('.')) sentence.pop_back();
  return join(sentences, "; ");
}

std::string points_cell(const ClassRow& row, const std::string& step) {
  for (const StepGrade& grade : row.grade.steps)
    if (grade.step == step && is_handed_in(grade.state)) return points_text(grade.points);
  return "";
}

std::string cell(const ClassRow& row, const GradebookColumn& column) {
  const Student& student = row.record.student;
  switch (column.field) {
    case Field::student:
      return safe_cell(student.name.empty() ? row.record.source : student.name);
    case Field::id:
      return safe_cell(student.id);
    case Field::identifier:
      return safe_cell(student.identifier);
    case Field::step:
      return points_cell(row, column.argument);
    case Field::total:
      return total_cell(row);
    case Field::late:
      return row.grade.late ? "yes" : "";
    case Field::needs_human:
      return row.grade.needs_human.empty() ? "" : safe_cell("yes: " + in_one_line(row.grade.needs_human));
    case Field::report:
      return report_folder(row.record);
    case Field::adjustment:
      return adjustment_text(row.grade.adjustment);
    case Field::comment:
      return safe_cell(row.comment);
    case Field::text:
      return safe_cell(column.argument);
  }
  return "";
}

}  // namespace

std::string safe_cell(std::string_view text) {
  std::string cleaned;
  while (!text.empty()) {
    const CodePoint c = first_code_point(text);
    const std::string_view bytes = text.substr(0, c.bytes);
    if (c.value == '\n' || c.value == '\t')
      cleaned += ' ';
    else if (!c.valid)
      cleaned += printable(bytes);
    else if (printable(bytes) == bytes && !is_invisible(c.value))
      cleaned += bytes;
    text.remove_prefix(c.bytes);
  }
  return begins_formula(cleaned) ? "'" + cleaned : cleaned;
}

std::vector<GradebookColumn> gradebook_columns(const ClassResults& results) {
  if (!results.course.columns.empty()) return results.course.columns;
  std::vector<GradebookColumn> columns = {{"student", Field::student, ""}, {"id", Field::id, ""}};
  for (const std::string& step : results.steps) columns.push_back({step, Field::step, step});
  columns.insert(columns.end(), {{"total", Field::total, ""},
                                 {"late", Field::late, ""},
                                 {"needs_human", Field::needs_human, ""},
                                 {"report", Field::report, ""}});
  if (results.commented)
    columns.insert(columns.end(), {{"adjustment", Field::adjustment, ""}, {"comment", Field::comment, ""}});
  return columns;
}

std::string gradebook_csv(const ClassResults& results) {
  const std::vector<GradebookColumn> columns = gradebook_columns(results);
  std::string csv = results.course.byte_order_mark ? "\xEF\xBB\xBF" : "";
  const auto add_row = [&](const auto& cell_of) {
    std::vector<std::string> cells;
    for (const GradebookColumn& column : columns) cells.push_back(csv_field(cell_of(column)));
    csv += join(cells, ",") + "\r\n";
  };
  add_row([](const GradebookColumn& column) { return safe_cell(column.heading); });
  for (const ClassRow& row : results.rows) add_row([&](const GradebookColumn& column) { return cell(row, column); });
  return csv;
}

}  // namespace atelier::grade
