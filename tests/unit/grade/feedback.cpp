#include "grade/course/feedback.hpp"

#include "catch.hpp"
#include "judge/report/report_html.hpp"
#include "judge/report/report_json.hpp"
#include "judge/report/report_words.hpp"

using namespace atelier;
using namespace atelier::grade;
using judge::CaseResult;
using judge::Status;

namespace {

constexpr const char* secret = "SECRET";

/// A result with this word in all that a student may not see at `where`.
judge::SubmissionResult telling_result() {
  judge::StepResult step{.step = "02-blinn-phong", .title = "Light", .score = 2, .max_score = 8};
  for (const Status status : {Status::passed, Status::failed, Status::crashed, Status::timeout}) {
    CaseResult c;
    c.name = "sphere-" + to_string(status), c.title = "A sphere", c.status = status, c.max_score = 2;
    c.score = status == Status::passed ? 2 : 0;
    c.asked = c.reason = c.hint = c.credit = c.command = c.table = c.output = c.measured = secret;
    c.hypothesis = c.mistake = c.mistake_sentence = secret;
    c.could_be = {secret};
    c.figures = {{secret, 1}};
    c.worst = judge::Worst{};
    c.evidence = judge::Evidence{.yours = Image(8, 8), .reference = Image(8, 8), .over = {}, .flip = {}, .mistake = {}};
    c.tier = "further";
    step.cases.push_back(c);
  }
  step.cases[2].waits_for = "shade";
  step.causes = {{.kind = judge::Cause::Kind::function,
                  .functions = {"shade"},
                  .inputs = 9,
                  .wrong = 4,
                  .shown = {1},
                  .waiting = {2, 3}}};
  step.build_log = "shade.cpp:3: warning";
  return {.submission = "ada", .score = 2, .max_score = 8, .steps = {step}, .environment = {}, .notes = {"a note"}};
}

std::string everything(const judge::SubmissionResult& result) {
  return results_json(result) + html_report(result);
}

}  // namespace

TEST_CASE("full feedback changes nothing") {
  judge::SubmissionResult result = telling_result();
  const std::string before = results_json(result);
  limit_feedback(result, Feedback::full);
  CHECK(results_json(result) == before);
  CHECK(test::mentions(before, {secret}));
}

TEST_CASE("feedback of where shows functions and cases, but nothing of what is expected") {
  judge::SubmissionResult result = telling_result();
  limit_feedback(result, Feedback::where);
  const std::string shown = everything(result);
  CHECK(shown.find(secret) == std::string::npos);
  CHECK(shown.find("<img") == std::string::npos);
  CHECK(shown.find("of 9 inputs") == std::string::npos);
  CHECK(test::mentions(shown, {"sphere-failed", "Begin with shade: wrong; 3 failing cases need it", "warning", "a note",
                               "The program crashed in this case."}));
  CHECK(result.score == 2);
  CHECK(result.steps[0].cases[0].tier == "further");
}

TEST_CASE("feedback of score shows the points of numbered cases") {
  judge::SubmissionResult result = telling_result();
  limit_feedback(result, Feedback::score);
  const std::string shown = everything(result);
  for (const char* hidden : {secret, "sphere", "shade", "<img", "warning"}) {
    INFO(hidden);
    CHECK(shown.find(hidden) == std::string::npos);
  }
  CHECK(test::mentions(shown, {"02-blinn-phong", "case-1", "Case 4", "2 / 8 points"}));
  CHECK(result.steps[0].cases[0].score == 2);
}

TEST_CASE("files that do not compile are explained at where, and only named at score") {
  for (const Feedback level : {Feedback::where, Feedback::score}) {
    judge::SubmissionResult result = telling_result();
    result.steps[0].cases.resize(1);
    result.steps[0].causes.clear();
    CaseResult& c = result.steps[0].cases[0];
    c.status = Status::build_failed, c.reason = "shade.cpp:3: error";
    limit_feedback(result, level);
    CHECK(c.reason == (level == Feedback::where ? "shade.cpp:3: error" : "The files did not compile."));
  }
}
