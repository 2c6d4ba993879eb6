#include "grade/course/feedback.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace atelier::grade {
namespace {

using judge::CaseResult;
using judge::Status;
using judge::StepResult;

/// What a status says by itself, without the program's own words: an exception's could hold the inputs of a case.
std::string reason_of(const CaseResult& result) {
  switch (result.status) {
    case Status::passed:
      return "The answer is right.";
    case Status::failed:
      return "The answer is wrong.";
    case Status::crashed:
      return "The program crashed in this case.";
    case Status::timeout:
      return "The program did not finish this case in time.";
    default:
      return result.reason;  // the compiler's words, or which files are missing
  }
}

CaseResult without_details(const CaseResult& result) {
  CaseResult shown;
  shown.name = result.name;
  shown.title = result.title;
  shown.status = result.status;
  shown.score = result.score;
  shown.max_score = result.max_score;
  shown.tier = result.tier;
  shown.reason = reason_of(result);
  shown.waits_for = result.waits_for;
  return shown;
}

/// Only the points of a case.
void show_points_alone(CaseResult& result, std::size_t number) {
  result.name = fmt::format("case-{}", number);
  result.title = fmt::format("Case {}", number);
  result.waits_for.clear();
  if (result.status == Status::missing) result.reason = "There is no answer.";
  if (result.status == Status::build_failed) result.reason = "The files did not compile.";
}

}  // namespace

void limit_feedback(judge::SubmissionResult& result, Feedback level) {
  if (level == Feedback::full) return;
  for (StepResult& step : result.steps) {
    std::transform(step.cases.begin(), step.cases.end(), step.cases.begin(), without_details);
    for (judge::Cause& cause : step.causes) cause.inputs = cause.wrong = 0;
    if (level == Feedback::where) continue;
    for (std::size_t i = 0; i < step.cases.size(); ++i) show_points_alone(step.cases[i], i + 1);
    step.causes.clear();
    step.build_log.clear();
  }
}

}  // namespace atelier::grade
