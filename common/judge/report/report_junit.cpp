#include "judge/report/report_junit.hpp"

#include <fmt/format.h>

#include "base/file.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::judge {
namespace {

bool is_error(Status status) {
  return status == Status::crashed || status == Status::timeout || status == Status::build_failed;
}

int errors(const StepResult& step) {
  return count(step, Status::crashed) + count(step, Status::timeout) + count(step, Status::build_failed);
}

int failures(const StepResult& step) {
  return count(step, Status::failed) + count(step, Status::missing);
}

std::string attribute(const char* name, std::string_view value) {
  return fmt::format(" {}=\"{}\"", name, escape_markup(value));
}

std::string property(std::string_view name, std::string_view value) {
  return "      <property" + attribute("name", name).append(attribute("value", value)) + "/>\n";
}

/// The text of a failed test: the verdict, then the numbers, then the program's output.
std::string explanation(const CaseResult& result) {
  std::string text = score_text(result.score, result.max_score) + "\n";
  for (const Remark& remark : remarks(result)) text += remark.label + ": " + remark.text + "\n";
  if (!result.table.empty()) text += "\n" + result.table + "\n";
  if (!result.output.empty()) text += "\noutput:\n" + result.output + "\n";
  return text;
}

std::string testcase(const StepResult& step, const CaseResult& result) {
  std::string xml = "    <testcase" + attribute("classname", step.step) + attribute("name", result.name) + ">\n";
  if (result.status == Status::passed) {
    xml += "      <system-out>" + escape_markup(score_text(result.score, result.max_score)) + "</system-out>\n";
  } else {
    const char* const tag = is_error(result.status) ? "error" : "failure";
    xml += fmt::format("      <{}{}{}>{}</{}>\n", tag, attribute("type", to_string(result.status)),
                       attribute("message", result.reason), escape_markup(explanation(result)), tag);
  }
  return xml + "    </testcase>\n";
}

std::string testsuite(const StepResult& step, const SubmissionResult& result) {
  std::string xml = fmt::format("  <testsuite{} tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"0\">\n",
                                attribute("name", step.step), step.cases.size(), failures(step), errors(step));
  xml += "    <properties>\n" + property("score", points_text(step.score)) +
         property("max_score", points_text(step.max_score));
  xml += property("references", step.references);
  for (const auto& [of_step, who] : step.implementations) xml += property("implementation of " + of_step, who);
  for (const auto& [name, value] : result.environment) xml += property(name, value);
  for (const std::string& note : result.notes) xml += property("note", note);
  xml += "    </properties>\n";
  for (const CaseResult& c : step.cases) xml += testcase(step, c);
  if (!step.build_log.empty()) xml += "    <system-err>" + escape_markup(step.build_log) + "</system-err>\n";
  return xml + "  </testsuite>\n";
}

}  // namespace

std::string junit_xml(const SubmissionResult& result) {
  std::size_t tests = 0;
  int failed = 0, broken = 0;
  std::string suites;
  for (const StepResult& step : result.steps) {
    tests += step.cases.size();
    failed += failures(step);
    broken += errors(step);
    suites += testsuite(step, result);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites{} tests=\"{}\" failures=\"{}\" errors=\"{}\">\n{}"
      "</testsuites>\n",
      attribute("name", result.submission), tests, failed, broken, suites);
}

void write_junit_xml(const std::filesystem::path& file, const SubmissionResult& result) {
  write_file(file, junit_xml(result));
}

}  // namespace atelier::judge
