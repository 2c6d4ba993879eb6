// Cases with numbers drawn for one submission, and the verdict on a case with both numbers.
#include "grade/varied_cases.hpp"

#include "catch.hpp"

using namespace atelier;
using namespace atelier::grade;
using atelier::test::mentions;
using judge::CaseResult;
using judge::JudgedCase;
using judge::Status;

namespace {

JudgedCase probe(const std::string& name, bool varies) {
  JudgedCase c;
  c.ask.name = name;
  c.ask.probe = "twice";
  c.ask.inputs.emplace_back().values = {{"x", {1}}};
  c.profile = judge::Profile::values;
  c.expected = {{2}};
  c.points = 3;
  if (varies) c.vary = judge::Variation{.count = 4, .like = {0}, .inputs = {{"x", {{0}, {100}, false}}}};
  return c;
}

CaseResult result(Status status, double score) {
  CaseResult result;
  result.name = "twice";
  result.status = status;
  result.score = score;
  result.max_score = 3;
  result.reason = status == Status::passed ? "Fine." : "Wrong.";
  result.command = "again";
  return result;
}

}  // namespace

TEST_CASE("numbers are drawn for the cases that vary, and their stored answers are dropped") {
  const std::vector<JudgedCase> cases = {probe("a", false), probe("b", true), probe("c", true)};
  const std::vector<VariedCase> drawn = draw_numbers(cases, 5);
  REQUIRE(drawn.size() == 2);
  CHECK(drawn[0].of == 1);
  CHECK(drawn[1].of == 2);
  CHECK(drawn[0].judged.ask.name == "b-varied");
  CHECK(drawn[0].judged.ask.inputs.size() == 4);
  CHECK(drawn[0].judged.expected.empty());
  CHECK(drawn[0].judged.points == 3);
  CHECK(drawn[0].judged.ask.inputs[0].values != drawn[1].judged.ask.inputs[0].values);
  CHECK(draw_numbers(cases, 5)[0].judged.ask.inputs[0].values == drawn[0].judged.ask.inputs[0].values);
  CHECK(draw_numbers(cases, 6)[0].judged.ask.inputs[0].values != drawn[0].judged.ask.inputs[0].values);
}

TEST_CASE("a case passes only if it passes with both numbers") {
  const CaseResult passed = result(Status::passed, 3), failed = result(Status::failed, 1);
  const CaseResult fine = both(passed, passed, "x = 2");
  CHECK(fine.status == Status::passed);
  CHECK(fine.score == 3);
  CHECK(fine.other_numbers.empty());
  CHECK(mentions(fine.reason, {"Fine.", "right with other numbers too (x = 2)"}));

  CaseResult varied = failed;
  varied.name = "twice-varied";
  varied.command = "never";
  const CaseResult caught = both(passed, varied, "x = 2");
  CHECK(caught.name == "twice");
  CHECK(caught.command == "again");
  CHECK(caught.status == Status::failed);
  CHECK(caught.score == 1);
  CHECK(caught.other_numbers == "x = 2");
  CHECK(mentions(caught.reason, {"(x = 2)", "Wrong."}));

  // What a student can repeat at home comes first.
  for (const CaseResult& other : {passed, failed}) {
    const CaseResult wrong = both(failed, other, "x = 2");
    CHECK(wrong.status == Status::failed);
    CHECK(wrong.reason == "Wrong.");
    CHECK(wrong.other_numbers.empty());
  }
}
