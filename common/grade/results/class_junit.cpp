#include "grade/results/class_junit.hpp"

#include <fmt/format.h>

#include "base/near_names.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::grade {
namespace {

using judge::escape_markup;
using judge::score_text;
using State = StepRecord::State;

/// How many test cases have ended how.
struct Tally {
  std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;

  void add(const Tally& other) {
    tests += other.tests, failures += other.failures, errors += other.errors, skipped += other.skipped;
  }
  std::string attributes() const {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\"", tests, failures, errors, skipped);
  }
};

std::string mistakes_text(const SubmissionRecord& record, const std::string& step) {
  std::vector<std::string> names;
  for (const StepRecord& each : record.steps)
    if (each.step == step)
      for (const auto& [mistake, cases] : each.mistakes) names.push_back(mistake);
  return names.empty() ? "" : "; looks like " + join(names);
}

/// What stands in a test case, which it counts in `tally`.
std::string outcome_xml(const StepGrade& grade, const SubmissionRecord& record, Tally& tally) {
  const std::string score = score_text(grade.points, grade.max_points);
  ++tally.tests;
  if (grade.state == State::not_handed_in || grade.state == State::untouched) {
    ++tally.skipped;
    return fmt::format("<skipped message=\"{}\"/>",
                       grade.state == State::untouched ? "as in the skeleton" : "not handed in");
  }
  if (grade.state == State::not_built) {
    ++tally.errors;
    return fmt::format("<error type=\"not_built\" message=\"{}; does not compile\"/>", score);
  }
  if (grade.points >= grade.max_points) return fmt::format("<system-out>{}</system-out>", score);
  ++tally.failures;
  const std::string late = grade.penalty > 0 ? fmt::format("; {} off for {} started days late",
                                                           judge::points_text(grade.penalty), grade.days_late)
                                             : "";
  return fmt::format("<failure type=\"points\" message=\"{}\"/>",
                     escape_markup(score + late + mistakes_text(record, grade.step)));
}

std::string suite_xml(const ClassRow& row, Tally& all) {
  Tally tally;
  const std::string id = escape_markup(row.record.student.id);
  std::string cases;
  for (const StepGrade& grade : row.grade.steps)
    cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\">{}</testcase>\n", id, escape_markup(grade.step),
                         outcome_xml(grade, row.record, tally));
  all.add(tally);
  return fmt::format("  <testsuite name=\"{}\" {}>\n{}  </testsuite>\n", id, tally.attributes(), cases);
}

}  // namespace

std::string class_junit_xml(const ClassResults& results) {
  Tally all;
  std::string suites;
  for (const ClassRow& row : results.rows) suites += suite_xml(row, all);
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" {}>\n{}</testsuites>\n",
                     escape_markup(results.summary.name), all.attributes(), suites);
}

}  // namespace atelier::grade
