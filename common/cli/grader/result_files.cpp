#include "cli/grader/result_files.hpp"

#include "base/replace_together.hpp"
#include "judge/compare/verdict.hpp"
#include "judge/report/report_html.hpp"
#include "judge/report/report_json.hpp"
#include "judge/report/report_junit.hpp"

namespace atelier {

void write_result_files(judge::SubmissionResult& result, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  for (judge::StepResult& step : result.steps)
    for (judge::CaseResult& c : step.cases) judge::draw_flip(c);
  replace_together({{folder / "results.json", [&](const fs::path& file) { judge::write_results_json(file, result); }},
                    {folder / "junit.xml", [&](const fs::path& file) { judge::write_junit_xml(file, result); }},
                    {folder / "report.html", [&](const fs::path& file) { judge::write_html_report(file, result); }}});
}

void remove_result_files(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const char* name : {"results.json", "junit.xml", "report.html"}) std::filesystem::remove(folder / name, ignored);
}

}  // namespace atelier
