#include "grade/results/class_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/replace_together.hpp"
#include "grade/results/class_json.hpp"
#include "grade/results/class_junit.hpp"
#include "grade/results/class_report.hpp"
#include "grade/results/gradebook.hpp"
#include "grade/results/student_comment.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::grade {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> counting_steps(const CourseFile& course, const std::vector<SubmissionRecord>& records) {
  std::set<std::string> steps;
  for (const StepRules& rules : course.steps) steps.insert(rules.step);
  for (const SubmissionRecord& record : records)
    for (const StepRecord& step : record.steps)
      if (course.counts(step.step)) steps.insert(step.step);
  return {steps.begin(), steps.end()};
}

void refuse_equal_ids(const std::vector<ClassRow>& rows) {
  const auto same = [](const ClassRow& a, const ClassRow& b) { return a.record.student.id == b.record.student.id; };
  const auto twice = std::adjacent_find(rows.begin(), rows.end(), same);
  if (twice != rows.end())
    throw Error(fmt::format("the id '{}' has two records, of {} and of {}; one row would hide the other",
                            twice->record.student.id, twice->record.source, (twice + 1)->record.source));
}

}  // namespace

ClassResults class_results(const fs::path& folder, const CourseFile& course, const ClassSummary& summary,
                           const std::vector<SubmissionRecord>& records) {
  ClassResults results{.summary = summary,
                       .course = course,
                       .steps = counting_steps(course, records),
                       .rows = {},
                       .unsaid = {},
                       .folder = folder};
  const fs::path file = folder / "comments.csv";
  const Comments comments = read_comments(file);
  std::vector<std::string> ids;
  for (const SubmissionRecord& record : records) {
    const auto found = comments.find(record.student.id);
    const Comment comment = found == comments.end() ? Comment{} : found->second;
    results.rows.push_back({record, grade_of(record, course, comment.points), comment.text});
    results.commented = results.commented || !comment.text.empty() || comment.points != 0;
    ids.push_back(record.student.id);
  }
  std::stable_sort(results.rows.begin(), results.rows.end(),
                   [](const ClassRow& a, const ClassRow& b) { return a.record.student.id < b.record.student.id; });
  refuse_equal_ids(results.rows);
  results.unsaid = misplaced_comments(comments, ids, file);
  return results;
}

std::string report_folder(const SubmissionRecord& record) {
  return "students/" + record.student.id;
}

double seconds_of_work(const SubmissionRecord& record) {
  double sum = 0;
  for (const auto& [part, seconds] : record.seconds)
    if (part != "wait") sum += seconds;
  return sum;
}

namespace {

/// How the course's rules have turned the points of the report into a grade; nothing where they are the same.
std::string grade_in_words(const ClassRow& row) {
  std::string lines;
  double earned = 0;
  for (const StepRecord& step : row.record.steps) earned += step.score;
  for (const StepGrade& step : row.grade.steps) {
    if (step.state != StepRecord::State::judged) continue;
    lines += fmt::format("{}: {} of {} points", step.step, judge::points_text(step.points),
                         judge::points_text(step.max_points));
    if (step.penalty > 0)
      lines += fmt::format("; {} taken off for {} started day{} after the deadline", judge::points_text(step.penalty),
                           step.days_late, step.days_late == 1 ? "" : "s");
    lines += ".\n";
  }
  if (rounded_points(earned) == rounded_points(row.grade.points - row.grade.adjustment)) return "";
  return fmt::format("In the course: {} of {} points.\n{}", judge::points_text(row.grade.points),
                     judge::points_text(row.grade.max_points), lines);
}

std::string with_grade(const ClassRow& row) {
  return grade_in_words(row) + row.comment;
}

}  // namespace

void write_class_results(const fs::path& out, const CourseFile& course, const ClassSummary& summary,
                         const std::vector<SubmissionRecord>& records) {
  const ClassResults results = class_results(out, course, summary, records);
  const auto writes = [](const std::string& text) { return [text](const fs::path& file) { write_file(file, text); }; };
  replace_together({{out / "gradebook.csv", writes(gradebook_csv(results))},
                    {out / "class.html", writes(class_html(results))},
                    {out / "class.json", writes(class_json(results))},
                    {out / "junit.xml", writes(class_junit_xml(results))}});
  create_comments(out / "comments.csv");
  for (const ClassRow& row : results.rows)
    set_comment(out / report_folder(row.record) / "report.html", with_grade(row), row.grade.adjustment);
}

}  // namespace atelier::grade
