#include "cli/student/hints.hpp"

#include "base/file.hpp"
#include "catch.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

constexpr const char* cases = R"({"schema": 1, "step": "01-move",
  "defaults": {"scene": "any", "asked": "A picture.", "points": 0},
  "cases": [{"name": "one", "title": "One", "hint": "Look at one.", "functions": ["turn"]},
            {"name": "both", "title": "Both", "hint": "Look at both.", "functions": ["turn", "shift"]},
            {"name": "given", "title": "Given", "hint": "Nothing to write."}]})";
constexpr const char* hints = R"({"schema": 1, "step": "01-move",
  "functions": {"turn": ["turn idea", "turn answer"], "shift": ["shift idea", "shift answer"]}})";

struct HintedCourse {
  TemporaryFolder root;
  ProjectFolders folders{.root = root.path(), .build = root.path() / "build"};
  CourseStep step{.name = "01-move"};
  ProgressRecord record;

  HintedCourse() {
    write_file(folders.case_file("01-move"), std::string_view(cases));
    write_file(folders.hints_file("01-move"), std::string_view(hints));
  }
  void checked(bool one, bool both, bool given) {
    record["01-move"].check = CheckRecord{.cases = {{"one", one}, {"both", both}, {"given", given}}};
  }
};

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("each call gives the next level, up to the last") {
  HintedCourse course;
  struct Row {
    int level;
    Texts texts;
  };
  for (const Row& row :
       {Row{1, {"Look at one."}}, Row{2, {"turn idea"}}, Row{3, {"turn answer"}}, Row{3, {"turn answer"}}}) {
    const Hint hint = next_hint(course.folders, course.step, "one", course.record);
    CHECK(hint.level == row.level);
    CHECK(hint.levels == 3);
    CHECK(hint.texts == row.texts);
    CHECK(hint_level(course.record, "01-move", "one") == row.level);
  }
  CHECK(hint_at(course.folders, course.step, "one", course.record, 1).texts == Texts{"Look at one."});
  CHECK(hint_level(course.record, "01-move", "one") == 3);
}

TEST_CASE("the first hint comes with the contracts of the functions in question") {
  HintedCourse course;
  course.step.headers = {"01-move/move.hpp"};
  course.step.files = {"move.cpp", "move.glsl"};
  write_file(course.folders.steps() / "01-move/move.hpp",
             std::string_view("/// Turns by `angle` radians.\nmat4 turn(float angle);\n\nvoid other();\n"));
  write_file(course.folders.steps() / "01-move/move.glsl",
             std::string_view("\n// Moves a point.\n// Metres.\nvec3 shift(vec3 p) { return p; }\n"));
  const auto contracts = [&](const char* name) {
    return hint_at(course.folders, course.step, name, course.record, 1).contracts;
  };
  REQUIRE(contracts("both").size() == 2);
  const Contract turn = contracts("both")[0], shift = contracts("both")[1];
  CHECK(turn.file == "steps/01-move/move.hpp");
  CHECK(turn.line == 2);
  CHECK(turn.text == "/// Turns by `angle` radians.\nmat4 turn(float angle)\n");
  CHECK(shift.line == 4);
  CHECK(shift.text == "// Moves a point.\n// Metres.\nvec3 shift(vec3 p)\n");
  CHECK(contracts("given").empty());
  CHECK(hint_at(course.folders, course.step, "both", course.record, 2).contracts.empty());

  // A student who took the comment away still has the one that was handed out.
  write_file(course.folders.steps() / "01-move/move.glsl", std::string_view("vec3 shift(vec3 p) { return p; }\n"));
  CHECK(contracts("both").size() == 1);
  write_file(course.folders.skeletons() / "01-move/move.glsl",
             std::string_view("// Moves a point.\nvec3 shift(vec3 p) { return p; }\n"));
  CHECK(contracts("both").at(1).text == "// Moves a point.\nvec3 shift(vec3 p)\n");
  CHECK(hint_text(hint_at(course.folders, course.step, "both", course.record, 1), 80).find("move.glsl:2\n  // Moves") !=
        std::string::npos);
  const TemporaryFolder elsewhere;  // ATELIER_WORK: the student's files are there, contracts are not
  course.folders.work = elsewhere.path();
  CHECK(contracts("both").at(0).text == turn.text);
}

TEST_CASE("without a name, the hint is for the first failed case") {
  HintedCourse course;
  const auto chosen = [&] { return hint_at(course.folders, course.step, "", course.record, 1).case_name; };
  CHECK(chosen() == "one");
  course.checked(true, false, false);
  CHECK(chosen() == "both");
  course.checked(true, true, true);
  CHECK(mentions(error_of(chosen), {"01-move", "every case"}));
  CHECK(mentions(error_of([&] { hint_at(course.folders, course.step, "bth", course.record, 1); }), {"bth", "'both'"}));
}

TEST_CASE("without a name, the hint is for the case that the verdict began with") {
  HintedCourse course;
  course.record["01-move"].check = CheckRecord{.cases = {{"one", false}, {"both", false}}, .begin_with = "both"};
  CHECK(next_hint(course.folders, course.step, "", course.record).case_name == "both");
  CHECK(next_hint(course.folders, course.step, "one", course.record).case_name == "one");
}

TEST_CASE("the hint is for the function that the verdict began with, whatever else the case tests") {
  HintedCourse course;
  course.record["01-move"].check = CheckRecord{
      .cases = {{"one", true}, {"both", false}}, .begin_with = "both", .wrong_function = "turn"};
  CHECK(hint_at(course.folders, course.step, "both", course.record, 2).functions == Texts{"turn"});
  course.record["01-move"].check->wrong_function = "no-function-of-this-case";
  CHECK(hint_at(course.folders, course.step, "both", course.record, 2).functions == Texts{"shift"});
}

TEST_CASE("a function whose own cases have passed needs no hint") {
  HintedCourse course;
  CHECK(hint_at(course.folders, course.step, "both", course.record, 2).functions == Texts{"turn", "shift"});
  course.checked(true, false, false);
  CHECK(hint_at(course.folders, course.step, "both", course.record, 2).texts == Texts{"shift idea"});
  CHECK(hint_at(course.folders, course.step, "one", course.record, 3).texts == Texts{"turn answer"});
}

TEST_CASE("a case that names no function has one hint") {
  HintedCourse course;
  const Hint hint = hint_at(course.folders, course.step, "given", course.record, 3);
  CHECK(hint.level == 1);
  CHECK(hint.levels == 1);
}

TEST_CASE("a hint has its level and the command for the next") {
  HintedCourse course;
  const std::string text = hint_text(hint_at(course.folders, course.step, "one", course.record, 2), 80);
  CHECK(mentions(text, {"one", "hint 2 of 3", "turn", "turn idea", "./atelier hint 01 one"}));
  CHECK(mentions(hint_text(hint_at(course.folders, course.step, "one", course.record, 3), 80), {"last"}));
}

TEST_CASE("a broken file of hints is refused with file and member") {
  HintedCourse course;
  const auto file = course.folders.hints_file("01-move");
  const judge::CaseFile known = judge::read_case_file(course.folders.case_file("01-move"));
  struct Row {
    const char *name, *text, *says;
  };
  const Row rows[] = {
      {"another step", R"({"schema": 1, "step": "02-x", "functions": {}})", "step"},
      {"a function without hints", R"({"schema": 1, "step": "01-move", "functions": {"turn": ["a", "b"]}})", "shift"},
      {"a function of no case",
       R"({"schema": 1, "step": "01-move", "functions": {"turn": ["a", "b"], "shft": ["a", "b"]}})", "'shift'"},
      {"one level only", R"({"schema": 1, "step": "01-move", "functions": {"turn": ["a"], "shift": ["a", "b"]}})",
       "levels 2 and 3"},
      {"an empty text", R"({"schema": 1, "step": "01-move", "functions": {"turn": ["a", ""], "shift": ["a", "b"]}})",
       "level 3"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    write_file(file, std::string_view(row.text));
    CHECK(mentions(error_of([&] { read_hints(file, known); }), {"hints.json", row.says}));
  }
}

TEST_CASE("every step of the course has hints for all functions that its cases name") {
  const ProjectFolders folders{.root = ATELIER_SOURCE_DIR, .build = {}};
  int steps = 0;
  for (const auto& folder : std::filesystem::directory_iterator(folders.cases())) {
    if (!folder.is_directory()) continue;
    const std::string step = folder.path().filename().string();
    INFO(step);
    CHECK(error_of([&] { read_hints(folders.hints_file(step), judge::read_case_file(folders.case_file(step))); }) ==
          "");
    ++steps;
  }
  CHECK(steps > 0);
}
