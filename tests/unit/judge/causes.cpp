// A step of three functions: near and far are asked by probes, blend by none. A picture needs all of them.
#include "judge/explain/causes.hpp"

#include "catch.hpp"
#include "judge/compare/verdict.hpp"
#include "judge/report/report_words.hpp"

using namespace atelier;
using namespace atelier::judge;

namespace {

using Values = std::vector<Numbers>;

JudgedCase probe(const std::string& name, const std::string& function) {
  JudgedCase c;
  c.ask.name = name;
  c.ask.probe = name;
  c.ask.inputs.resize(2);
  c.profile = Profile::values;
  c.functions = {function};
  c.hint = "the case's own hint";
  c.points = 1;
  return c;
}

JudgedCase picture(const std::string& name) {
  JudgedCase c;
  c.ask.name = name;
  c.functions = {"blend"};
  c.hint = "the case's own hint";
  c.points = 1;
  return c;
}

Mistake mistake(const std::string& name) {
  Mistake known;
  known.name = name;
  known.sentence = "It is " + name + ".";
  known.hint = "hint of " + name;
  return known;
}

/// Verdicts as judge_case gives them, on answers that a test chooses.
class Step {
 public:
  Step() : references_("05-mist", {mistake("halved"), mistake("doubled"), mistake("inverted"), mistake("split")}) {
    add(probe("near", "near"), {"near"},
        {{"halved", {{0.5}, {0.5}}},
         {"doubled", {{2}, {2}}},
         {"doubled~1", {{3}, {3}}},
         {"split", {{4}, {4}}},
         {"split~1", {}}},
        {{{0}, {0}}});
    add(probe("far", "far"), {"far", "near"},
        {{"halved", {{0.5}, {1}}}, {"split", {{5}, {5}}}, {"split~1", {{6}, {6}}}}, {{{0}, {0}}});
    for (const char* name : {"hill", "lake"}) {
      CaseReferences right;
      right.needs = {"blend", "far", "near"};
      right.shows = {"halved", "doubled", "inverted"};
      cases_.push_back(picture(name));
      references_.add(name, right);
      step_.cases.push_back(passed(name));
    }
  }

  /// A second probe of the function near, which "split" does not change.
  void ask_near_again() { add(probe("near-again", "near"), {"near"}, {}, {{{0}, {0}}}); }

  /// A probe of near and far together, whose first function is near.
  void ask_both() {
    JudgedCase both = probe("both", "near");
    both.functions = {"near", "far"};
    both.together = true;
    add(both, {"near", "far"}, {}, {{{0}, {0}}});
  }

  void answer(const std::string& name, const Values& values) {
    const std::size_t i = index(name);
    Answer answer;
    answer.ended = Answer::Ended::normally;
    answer.values = values;
    step_.cases[i] = judge_case(cases_[i], answer, references_);
  }

  /// A wrong picture that looks like a mistake, or like none.
  void draw(const std::string& name, const std::string& like, int failing_pixels = 500) {
    CaseResult& result = step_.cases[index(name)];
    result.status = Status::failed;
    result.figures = {{"over", failing_pixels}, {"share", failing_pixels / 1e6}};
    result.hint = "the case's own hint";
    if (!like.empty()) result.could_be = {like};
  }

  void lose(const std::string& name) { step_.cases[index(name)].status = Status::missing; }
  void crash(const std::string& name) { step_.cases[index(name)].status = Status::crashed; }
  void time_out(const std::string& name, const std::string& reason) {
    step_.cases[index(name)].status = Status::timeout;
    step_.cases[index(name)].reason = reason;
  }

  const StepResult& explained() {
    explain_step(step_, cases_, references_);
    return step_;
  }
  const CaseResult& of(const std::string& name) const { return step_.cases[index(name)]; }

 private:
  static CaseResult passed(const std::string& name) {
    CaseResult result;
    result.name = name;
    result.status = Status::passed;
    return result;
  }

  std::size_t index(const std::string& name) const {
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (cases_[i].ask.name == name) return i;
    throw std::out_of_range(name);
  }

  void add(const JudgedCase& c, std::vector<std::string> needs, std::map<std::string, Values> mistakes,
           std::vector<Values> unwritten) {
    CaseReferences right;
    right.values = {{1}, {1}};
    right.needs = std::move(needs);
    references_.add(c.ask.name, right, {{}, {.mistakes = std::move(mistakes), .unwritten = std::move(unwritten)}});
    cases_.push_back(c);
    step_.cases.push_back(passed(c.ask.name));
  }

  std::vector<JudgedCase> cases_;
  StepReferences references_;
  StepResult step_;
};

std::string headlines(const StepResult& step) {
  std::string text;
  for (std::size_t i = 0; i < step.causes.size(); ++i) text += headline(step, i) + "\n";
  return text;
}

std::string waiting(const StepResult& step, std::size_t cause) {
  std::string names;
  for (const std::size_t i : step.causes[cause].waiting) names += step.cases[i].name + " ";
  return names;
}

}  // namespace

TEST_CASE("a step without failures has no causes") {
  CHECK(Step().explained().causes.empty());
}

TEST_CASE("the first cause is the function that others need") {
  Step step;
  step.answer("near", {{3}, {1}});
  step.answer("far", {{9}, {9}});
  step.draw("hill", "");
  CHECK(headlines(step.explained()) == "Begin with near: wrong for 1 of 2 inputs; 3 failing cases need it\n");
  CHECK(waiting(step.explained(), 0) == "hill far ");  // the picture first
  CHECK(step.of("far").waits_for == "near");
  CHECK(step.of("near").waits_for.empty());
  CHECK(test::mentions(step.of("hill").hint, {"near", "first"}));
  CHECK(step.of("near").hint == "the case's own hint");
}

TEST_CASE("a function is wrong if its probe fails and what it needs is right") {
  Step step;
  step.answer("far", {{9}, {9}});
  step.draw("lake", "");
  CHECK(headlines(step.explained()) == "Begin with far: wrong for every input; 2 failing cases need it\n");
}

TEST_CASE("a crash in a probe is a wrong answer of its function") {
  Step step;
  step.crash("near");
  step.draw("hill", "");
  CHECK(headlines(step.explained()) == "Begin with near: wrong for every input; 2 failing cases need it\n");
}

TEST_CASE("a probe without an answer is a wrong answer of its function") {
  Step step;
  step.lose("far");
  step.draw("hill", "");
  CHECK(headlines(step.explained()) == "Begin with far: wrong for every input; 2 failing cases need it\n");
}

TEST_CASE("functions as in the skeleton come last, and nothing is diagnosed of them") {
  Step step;
  step.answer("near", {{0}, {0}});
  step.answer("far", {{7}, {1}});
  step.draw("hill", "inverted");
  CHECK(test::mentions(headlines(step.explained()),
                       {"Begin with near: it answers as in the skeleton; 3 failing cases need it"}));
  CHECK_FALSE(step.of("hill").mistake.has_value());
  CHECK_FALSE(step.of("near").hypothesis.has_value());

  Step both;
  both.answer("near", {{0}, {0}});
  both.answer("far", {{0}, {0}});
  REQUIRE(both.explained().causes.size() == 1);
  CHECK(both.explained().causes[0].functions[0] == "near");
}

TEST_CASE("pictures that fail although all probes pass") {
  Step step;
  step.draw("hill", "");
  step.draw("lake", "", 900);
  const StepResult& result = step.explained();
  CHECK(headlines(result) == "Begin with lake: all probes of the functions that it needs pass\n");
  CHECK(waiting(result, 0) == "hill ");
  CHECK(result.causes[0].functions == std::vector<std::string>{"blend"});
}

TEST_CASE("a mistake is named only if no other answer contradicts it") {
  SECTION("no probe would change: the picture alone") {
    Step step;
    step.draw("hill", "inverted");
    step.draw("lake", "inverted");
    step.explained();
    CHECK(step.of("hill").mistake == "inverted");
    CHECK(step.of("hill").mistake_sentence == "It is inverted.");
    CHECK(step.of("hill").hint == "hint of inverted");
  }
  SECTION("another picture that it would change passes") {
    Step step;
    step.draw("hill", "inverted");
    step.explained();
    CHECK_FALSE(step.of("hill").mistake.has_value());
  }
  SECTION("a handful of pixels") {
    Step step;
    step.draw("hill", "inverted", min_failing_pixels - 1);
    step.draw("lake", "inverted");
    step.explained();
    CHECK_FALSE(step.of("hill").mistake.has_value());
    CHECK(step.of("lake").mistake == "inverted");
  }
  SECTION("a probe that it would change passes") {
    Step step;
    step.draw("hill", "doubled");
    step.draw("lake", "doubled");
    step.explained();
    CHECK_FALSE(step.of("hill").mistake.has_value());
  }
  SECTION("one of two probes returns other numbers") {
    Step step;
    step.answer("near", {{0.5}, {0.5}});
    step.answer("far", {{0.5}, {0.25}});
    step.explained();
    CHECK(step.of("near").could_be == std::vector<std::string>{"halved"});
    CHECK_FALSE(step.of("near").mistake.has_value());
  }
  SECTION("another probe of the same function fails for another reason") {
    Step step;
    step.answer("near", {{4}, {4}});
    step.answer("far", {{5}, {5}});
    step.ask_near_again();
    step.answer("near-again", {{9}, {9}});
    step.explained();
    CHECK_FALSE(step.of("near").mistake.has_value());
  }
  SECTION("each probe may return the numbers of another form") {
    Step step;
    step.answer("near", {{4}, {4}});
    step.answer("far", {{6}, {6}});
    step.explained();
    CHECK(step.of("near").mistake == "split");
    Step half;
    half.answer("far", {{6}, {6}});
    half.explained();
    CHECK(half.of("far").mistake == "split");  // this form does not change the other probe
  }
  SECTION("a picture that passes says nothing of other forms than the one that was drawn") {
    Step drawn;
    drawn.draw("hill", "");
    drawn.answer("near", {{2}, {2}});
    drawn.explained();
    CHECK_FALSE(drawn.of("near").mistake.has_value());  // lake passes, which "doubled" would change
    Step other;
    other.draw("hill", "");
    other.answer("near", {{3}, {3}});
    other.explained();
    CHECK(other.of("near").mistake == "doubled");
  }
  SECTION("all probes return its numbers") {
    Step step;
    step.answer("near", {{0.5}, {0.5}});
    step.answer("far", {{0.5}, {1}});
    step.draw("hill", "halved");
    step.draw("lake", "inverted");
    step.explained();
    CHECK(step.of("near").mistake == "halved");
    CHECK(step.of("far").mistake == "halved");
    CHECK(step.of("hill").mistake == "halved");        // it waits, and a probe confirms it
    CHECK_FALSE(step.of("lake").mistake.has_value());  // it waits, and no probe confirms that
  }
}

TEST_CASE("what is not there, or ends in the same way everywhere, is one cause") {
  Step step;
  for (const char* name : {"near", "far", "hill"}) step.crash(name);
  const StepResult& result = step.explained();
  REQUIRE(result.causes.size() == 1);
  CHECK(result.causes[0].kind == Cause::Kind::no_answer);
  CHECK(headlines(result) == "Begin with these 3 cases: crashed\n");
}

TEST_CASE("what took too long comes before the cases that were not run because of it") {
  Step step;
  step.time_out("near", "it took longer than 10 s");
  for (const char* name : {"far", "hill", "lake"}) step.time_out(name, "not run");
  const StepResult& result = step.explained();
  REQUIRE(result.causes.size() == 2);
  CHECK(result.causes[0].functions == std::vector<std::string>{"near"});
  CHECK(result.causes[1].kind == Cause::Kind::no_answer);
  CHECK(result.causes[1].shown.size() == 3);
}

TEST_CASE("a probe of several functions together accuses none that its own probes clear", "[causes]") {
  Step step;
  step.ask_both();
  SECTION("one of them is wrong by its own probe") {
    step.answer("far", {{7}, {7}});
    step.answer("both", {{9}, {9}});
    const StepResult& result = step.explained();
    REQUIRE(result.causes.size() == 1);
    CHECK(result.causes[0].functions == std::vector<std::string>{"far"});
    CHECK(waiting(result, 0) == "both ");
  }
  SECTION("none is") {
    step.answer("both", {{9}, {9}});
    const StepResult& result = step.explained();
    REQUIRE(result.causes.size() == 1);
    CHECK(result.causes[0].kind == Cause::Kind::picture);
    CHECK(headlines(result).find("near") == std::string::npos);
  }
}
