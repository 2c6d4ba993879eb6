#include "judge/report/kept_steps.hpp"

#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "catch.hpp"
#include "judge/report/report_html.hpp"
#include "judge/report/report_json.hpp"

using namespace atelier;
using namespace atelier::judge;

namespace {

StepResult step(const std::string& name, double score, const std::string& output = "") {
  StepResult result{.step = name, .title = "Light", .score = score, .max_score = 10, .cases = {}};
  CaseResult c{.name = "sphere", .title = "A sphere", .status = score < 10 ? Status::failed : Status::passed};
  c.score = score, c.max_score = 10, c.reason = "too dark", c.output = output;
  result.cases = {c};
  return result;
}

SubmissionResult graded(std::vector<StepResult> steps) {
  SubmissionResult result{.submission = "ada", .may_grow = true};
  result.steps = std::move(steps);
  return result;
}

void write(const std::filesystem::path& folder, const SubmissionResult& result) {
  write_results_json(folder / "results.json", result);
  write_html_report(folder / "report.html", result);
}

std::string part(const std::string& html, const std::string& anchor) {
  const std::size_t begin = html.find("id=\"" + anchor + "\"");
  return html.substr(begin, html.find("<!-- end of the step -->", begin) - begin);
}

}  // namespace

TEST_CASE("steps that are not graded again stay in all reports as they were") {
  const TemporaryFolder folder;
  const SubmissionResult before =
      graded({step("01-move", 4, "<b>words</b> <!-- end of the step -->"), step("02-light", 7)});
  write(folder.path(), before);

  SubmissionResult after = graded({step("02-light", 10)});
  for (StepResult& kept : kept_steps(folder.path(), after.steps)) after.steps.insert(after.steps.begin(), kept);
  REQUIRE(after.steps.size() == 2);
  CHECK(after.steps[0].step == "01-move");
  CHECK(after.steps[0].score == 4);
  CHECK(after.steps[0].cases.at(0).status == Status::failed);
  CHECK(part(html_report(after), "step-01-move") == part(html_report(before), "step-01-move"));
  CHECK(part(html_report(after), "step-02-light") != part(html_report(before), "step-02-light"));
  const auto json = nlohmann::json::parse(results_json(after)), old = nlohmann::json::parse(results_json(before));
  CHECK(json.at("steps").at(0) == old.at("steps").at(0));
  CHECK(json.at("steps").at(1) != old.at("steps").at(1));

  write(folder.path(), after);  // and once more, from a report with a kept step
  CHECK(kept_steps(folder.path(), {}).at(0).kept->html == after.steps[0].kept->html);
}

TEST_CASE("without an earlier report, or with one that cannot be read, nothing is kept") {
  const TemporaryFolder folder;
  CHECK(kept_steps(folder.path(), {}).empty());
  write(folder.path(), graded({step("01-move", 4)}));
  REQUIRE(kept_steps(folder.path(), {}).size() == 1);
  write_file(folder.path() / "report.html", "<html>of another version</html>");
  CHECK(kept_steps(folder.path(), {}).empty());
  write(folder.path(), graded({step("01-move", 4)}));
  write_file(folder.path() / "results.json", "{\"steps\": [{}]}");
  CHECK(kept_steps(folder.path(), {}).empty());
}
