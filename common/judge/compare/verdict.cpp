#include "judge/compare/verdict.hpp"

#include <fmt/format.h>

#include <utility>

#include "image/flip.hpp"
#include "judge/compare/verdict_parts.hpp"

namespace atelier::judge {

Status status_of(Answer::Ended ended) {
  switch (ended) {
    case Answer::Ended::normally:
      return Status::failed;
    case Answer::Ended::missing:
      return Status::missing;
    case Answer::Ended::crashed:
      return Status::crashed;
    case Answer::Ended::timeout:
      return Status::timeout;
    case Answer::Ended::build_failed:
      return Status::build_failed;
  }
  return Status::missing;
}

namespace {

std::string default_reason(Status status) {
  switch (status) {
    case Status::crashed:
      return "The program crashed in this case.";
    case Status::timeout:
      return "The program did not finish this case in time.";
    case Status::build_failed:
      return "The files did not compile.";
    default:
      return "The program wrote no answer for this case.";
  }
}

/// The hint if there is no answer; the case's own hint is about a wrong answer.
std::string hint_without_answer(Status status, const std::string& hint_of_case) {
  switch (status) {
    case Status::build_failed:
      return "Fix the first compiler error; cases that need this file cannot be judged before.";
    case Status::crashed:
      return "Look for an index out of range, a null pointer, an endless recursion, or an uncaught exception; a "
             "debugger "
             "shows the line.";
    case Status::timeout:
      return "Look for an endless loop, or a loop that adds work while it runs.";
    default:
      return hint_of_case;
  }
}

CaseResult blank(const JudgedCase& c, const Answer& answer, const StepReferences& references) {
  CaseResult result;
  result.name = c.ask.name;
  result.title = c.title;
  result.status = status_of(answer.ended);
  result.max_score = c.points;
  result.tier = c.tier;
  result.asked = c.asked;
  result.hint = c.hint;
  result.command = fmt::format("./atelier check {} --case {}", references.step(), c.ask.name);
  result.output = answer.output;
  return result;
}

}  // namespace

void give_full_credit(CaseResult& result) {
  result.status = Status::passed;
  result.score = result.max_score;
  result.hint.clear();
}

void give_partial_credit(CaseResult& result, const Credit& credit) {
  result.score = credit.fraction * result.max_score;
  result.credit = result.score > 0 ? credit.explanation : "";
}

void add_hypothesis(CaseResult& result, const Hypothesis& whole) {
  result.hypothesis = whole.name;
  result.measured = result.reason;
  result.reason = whole.sentence + " " + result.reason;
  result.hint = whole.hint;
}

std::string reason_without_answer(Status status, const Answer& answer) {
  return answer.error.empty() ? default_reason(status) : answer.error;
}

void set_missing(CaseResult& result, const Answer& answer) {
  result.status = Status::missing;
  result.reason = reason_without_answer(Status::missing, answer);
}

CaseResult judge_case(const JudgedCase& c, const Answer& answer, const StepReferences& references, KeepEvidence keep) {
  references.of(c);  // report a broken reference whatever the answer is
  CaseResult result = blank(c, answer, references);
  if (answer.ended != Answer::Ended::normally) {
    result.reason = reason_without_answer(result.status, answer);
    result.hint = hint_without_answer(result.status, c.hint);
    return result;
  }
  if (c.choice) return judge_choice(std::move(result), c, answer, references, keep);
  return c.profile == Profile::values ? judge_probe(std::move(result), c, answer, references)
                                      : judge_picture(std::move(result), c, answer, references, keep);
}

void draw_flip(CaseResult& result) {
  if (!result.evidence || !result.evidence->colours || !result.evidence->flip.empty()) return;
  Evidence& evidence = *result.evidence;
  FlipOptions options;
  options.encoding = Encoding::srgb;
  Flip error = flip(evidence.reference, evidence.yours, options);
  evidence.flip = std::move(error.map);
  result.figures["flip_mean"] = error.mean;
}

}  // namespace atelier::judge
