// Missing parts of a step are reported, with the file and what to add.
#include "cli/author/step_rules.hpp"

#include "base/file.hpp"
#include "catch.hpp"
#include "cli/author/mistake_list.hpp"

using namespace atelier;
using atelier::test::mentions;

namespace {

/// A step with one case, to which files are added.
struct RuledStep {
  TemporaryFolder folder;
  ProjectFolders folders{.root = folder.path(), .build = {}};
  CourseStep step = {.name = "05-mist", .title = "Mist", .files = {"mist.cpp"}, .headers = {}, .uses = {}};

  RuledStep() {
    put("tests/cases/05-mist/cases.json", R"({"schema": 1, "step": "05-mist", "cases": [
      {"name": "hill", "title": "a", "asked": "a", "hint": "a", "points": 4, "scene": "s", "rejects": ["x"],
       "functions": ["through_mist"]}]})");
  }
  void put(const std::string& path, const std::string& text) { write_file(folder.path() / path, text); }
};

/// Whether the rules ask for one thing, in these words.
bool asks(const Problems& lacks, std::initializer_list<std::string_view> words) {
  return lacks.size() == 1 && mentions(lacks.front(), words);
}

measure::SweepResult swept(const std::string& name, bool handout) {
  measure::SweepResult sweep{.plan = {.name = name, .setting = "mist.pieces"}, .numeric = true, .points = {}};
  sweep.plan.handout = handout;
  sweep.plan.expect = {{.number = -1, .tolerance = 0.1, .reason = "theory"}};
  for (int n = 1; n <= 64; n *= 2)
    sweep.points.push_back({.value = std::to_string(n), .x = double(n), .error = 1.0 / n});
  return sweep;
}

}  // namespace

TEST_CASE("missing tests of a step are reported") {
  RuledStep made;
  CHECK(problems_of_tests(made.folders, made.step).empty());  // a release has no tests
  made.put("tests/steps/required_other.cpp", "TEST_CASE(\"x\", \"[required][04-other]\") {}");
  made.put("tests/stability/05-mist/table.cpp", "table.of(\"through_mist_twice\");");
  const Problems both = problems_of_tests(made.folders, made.step);
  REQUIRE(both.size() == 2);
  CHECK(mentions(both[0], {"tests/steps/required", "[required][05-mist]"}));
  CHECK(mentions(both[1], {"tests/stability/05-mist/", "through_mist"}));
  made.put("tests/steps/required_mist.cpp", "TEST_CASE(\"x\", \"[required][05-mist]\") {}");
  made.put("tests/stability/05-mist/mist.cpp", "table.of(\"through_mist (GLSL)\");");
  CHECK(problems_of_tests(made.folders, made.step).empty());
}

TEST_CASE("missing hints and missing parts of the handout are reported") {
  RuledStep made;
  made.put("tests/cases/05-mist/hints.json",
           R"({"schema": 1, "step": "05-mist", "functions": {"through_mist": ["two", "three"]}})");
  CHECK(asks(problems_of_cases(made.folders, made.step), {"handouts/05-mist.md is missing"}));
  made.put("handouts/05-mist.md", "\n| core | 1 | 4 | a |\n");
  CHECK(asks(problems_of_cases(made.folders, made.step), {"handouts/05-mist.md", "`hill`"}));
  made.put("handouts/05-mist.md", "\n| core | 1 | 5 | a |\n`hill`");
  CHECK(asks(problems_of_cases(made.folders, made.step), {"handouts/05-mist.md", "| core | HOURS | 4 |"}));
  made.put("handouts/05-mist.md", "\n| core | 1 | 4 | a |\n| further | 1 | 2 | b |\n`hill`");
  CHECK(asks(problems_of_cases(made.folders, made.step), {"handouts/05-mist.md", "row of further"}));
  made.put("handouts/05-mist.md", "\n| core | 1 | 4 | a |\n`hill`");
  CHECK(problems_of_cases(made.folders, made.step).empty());
  made.put("tests/cases/05-mist/hints.json", R"({"schema": 1, "step": "05-mist", "functions": {}})");
  CHECK(asks(problems_of_cases(made.folders, made.step), {"hints.json", "through_mist"}));
}

TEST_CASE("missing second spellings, variants and texts are reported") {
  RuledStep made;
  made.put("tests/mistakes/05-mist/thick.patch", "-");
  made.put("tests/mistakes/05-mist/thick.other.patch", "-");
  made.put("tests/variants/05-mist/thin.patch", "-");
  const std::string entry =
      R"([{"name": "thick", "title": "a", "sentence": "b", "hint": "c", "patch": "thick.patch"SPELLING}])";
  const auto with = [&](const std::string& spelling) {
    std::string text = entry;
    return text.replace(text.find("SPELLING"), 8, spelling);
  };
  made.put("tests/mistakes/05-mist/mistakes.json", with(R"(, "spellings": ["thick.other.patch"])"));
  CHECK(asks(problems_of_mistakes(made.folders, made.step), {"variants.json is missing", "--variant --begin"}));
  made.put("tests/variants/05-mist/variants.json", with_entry("", variant_entry("thin"), "variants.json"));
  CHECK(asks(problems_of_mistakes(made.folders, made.step), {"variants.json", "TO BE WRITTEN"}));
  made.put("tests/variants/05-mist/variants.json", R"([{"name": "thin", "title": "a", "patch": "thin.patch"}])");
  CHECK(problems_of_mistakes(made.folders, made.step).empty());
  made.put("tests/mistakes/05-mist/mistakes.json", with(""));
  CHECK(asks(problems_of_mistakes(made.folders, made.step), {"mistakes.json", "'thick'", "--spelling --begin"}));
}

TEST_CASE("missing slopes, expectations and plots are reported") {
  RuledStep made;
  made.put("handouts/05-mist.md", "![What it shows](plots/05-pieces.svg)");
  measure::StepMeasured measured{.step = "05-mist"};
  measured.sweeps = {swept("pieces", true), swept("more-pieces", false)};
  CHECK(problems_of_measured(made.folders, measured).empty());
  measured.sweeps[0].plan.handout = false;
  CHECK(asks(problems_of_measured(made.folders, measured), {"measure.json", "\"handout\": true"}));
  measured.sweeps[0].plan.handout = measured.sweeps[1].plan.handout = true;
  CHECK(asks(problems_of_measured(made.folders, measured), {"handouts/05-mist.md", "plots/05-more-pieces.svg"}));
  measured.sweeps[1] = swept("more-pieces", false);
  measured.sweeps[1].plan.expect.clear();
  CHECK(asks(problems_of_measured(made.folders, measured), {"measure.json", "'more-pieces'", "expect"}));
  measured.sweeps[1] = swept("more-pieces", false);
  measured.sweeps[1].plan.count = "triangles";  // a count is no error
  CHECK(asks(problems_of_measured(made.folders, measured), {"measure.json", "1 of its sweeps", "two must"}));
  measured.sweeps.pop_back();
  CHECK(asks(problems_of_measured(made.folders, measured), {"measure.json", "1 of its sweeps", "two must"}));
  CHECK(in_lines({"one", "two"}) == "! one\n! two\n");
}
