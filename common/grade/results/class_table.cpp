#include "grade/results/class_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/near_names.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::grade {
namespace {

using judge::escape_markup;
using judge::points_text;
using State = StepRecord::State;

std::string heading_html(const std::string& text, const std::string& below = "", const std::string& title = "") {
  const std::string small = below.empty() ? "" : " <small>" + escape_markup(below) + "</small>";
  const std::string hint = title.empty() ? "" : " title=\"" + escape_markup(title) + "\"";
  return fmt::format("<th scope=\"col\"{}><button type=\"button\">{}{}</button></th>", hint, escape_markup(text),
                     small);
}

std::string step_heading_html(const StepStatistics& step) {
  const std::size_t dash = step.step.find('-');
  const std::string name = dash == std::string::npos ? "" : step.step.substr(dash + 1) + " ";
  return heading_html(step.step.substr(0, dash), name + "/\u00a0" + points_text(step.max_points), step.title);
}

/// How full the points are, as a class of the cell.
const char* fullness(double points, double max_points) {
  if (points >= max_points) return "full";
  if (points <= 0) return "none";
  return points * 2 >= max_points ? "most" : "some";
}

std::string mark_html(const char* mark, const std::string& meaning) {
  return fmt::format(" <abbr title=\"{}\">{}</abbr>", escape_markup(meaning), mark);
}

std::string step_cell_html(const StepGrade* grade) {
  if (grade == nullptr || grade->state == State::not_handed_in) return "<td class=\"absent\">&ndash;</td>";
  std::string marks;
  if (grade->state == State::not_built) marks += mark_html("B", "does not compile, or files are missing");
  if (grade->state == State::untouched) marks += mark_html("S", "as in the skeleton");
  if (grade->days_late > 0)
    marks += mark_html("L", fmt::format("{} started {} late: {} points off", grade->days_late,
                                        grade->days_late == 1 ? "day" : "days", points_text(grade->penalty)));
  return fmt::format("<td class=\"{}\" data-value=\"{}\">{}{}</td>", fullness(grade->points, grade->max_points),
                     grade->points, points_text(grade->points), marks);
}

std::string total_cell_html(const ClassRow& row) {
  const double added = row.grade.adjustment;
  const std::string mark =
      added == 0 ? ""
                 : mark_html("A", fmt::format("{} points {} by a person", points_text(std::max(added, -added)),
                                              added < 0 ? "taken off" : "added"));
  return fmt::format("<td class=\"sum\" data-value=\"{}\">{}{}</td>", row.grade.points, points_text(row.grade.points),
                     mark);
}

std::string row_html(const ClassResults& results, const ClassRow& row) {
  std::string html = fmt::format("<tr><th scope=\"row\">{}</th><td class=\"mono\">{}</td>", student_link(row),
                                 escape_markup(row.record.student.id));
  for (const std::string& step : results.steps) html += step_cell_html(step_grade(row, step));
  html += total_cell_html(row) + (row.grade.late ? "<td data-value=\"1\">late</td>" : "<td></td>");
  const std::vector<std::string>& reasons = row.grade.needs_human;
  if (reasons.empty())
    html += "<td></td>";
  else
    html += fmt::format("<td class=\"human\" data-value=\"{}\" title=\"{}\">yes</td>", reasons.size(),
                        escape_markup(join(reasons, " ")));
  if (results.commented) html += "<td class=\"remark\">" + escape_markup(row.comment) + "</td>";
  return html + "</tr>\n";
}

}  // namespace

std::string student_link(const ClassRow& row) {
  const Student& student = row.record.student;
  const std::string& name = student.name.empty() ? row.record.source : student.name;
  return fmt::format("<a href=\"{}/report.html\">{}</a>", escape_markup(report_folder(row.record)),
                     escape_markup(name.empty() ? student.id : name));
}

std::string students_words(std::size_t number) {
  return fmt::format("{} {}", number, number == 1 ? "student" : "students");
}

std::string class_table_html(const ClassResults& results, const ClassStatistics& statistics) {
  std::string html =
      "<div class=\"tools\" hidden><label>Search <input type=\"search\" id=\"search\"></label> <label><input "
      "type=\"checkbox\" id=\"human\"> only those who need a human</label> <span class=\"soft\" id=\"shown\" "
      "role=\"status\"></span></div>\n"
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Table of all students\">\n"
      "<table id=\"class\">\n<thead>\n<tr>" +
      heading_html("student") + heading_html("id");
  double most = 0;
  for (const ClassRow& row : results.rows) most = std::max(most, row.grade.max_points);
  for (const StepStatistics& step : statistics.steps) html += step_heading_html(step);
  html += heading_html("total", "/\u00a0" + points_text(most)) + heading_html("late") + heading_html("human");
  if (results.commented) html += heading_html("comment");
  html += "</tr>\n</thead>\n<tbody>\n";
  for (const ClassRow& row : results.rows) html += row_html(results, row);
  return html +
         "</tbody>\n</table>\n</div>\n<p class=\"soft legend\">&ndash; not handed in &middot; B does not compile "
         "&middot; S as in the skeleton &middot; L late &middot; A changed by a person</p>\n";
}

}  // namespace atelier::grade
