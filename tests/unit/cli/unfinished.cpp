// What a student reads first if an earlier step is not finished and no solution stands in.
#include "cli/student/unfinished.hpp"

#include "base/file.hpp"
#include "catch.hpp"
#include "cli/student/progress_record.hpp"

using namespace atelier;
using atelier::test::mentions;

namespace {

/// A release of three steps; the third uses the others.
struct TwoStepCourse {
  TemporaryFolder root;
  ProjectFolders folders{.root = root.path(), .build = root.path() / "build"};
  std::vector<CourseStep> course = {{.name = "01-move", .files = {"move.glsl"}},
                                    {.name = "02-light", .files = {"light.glsl"}},
                                    {.name = "03-shadow", .uses = {"01-move", "02-light"}}};
  Owners owners = {{"01-move", Owner::mine}, {"02-light", Owner::mine}};

  TwoStepCourse() {
    for (const std::string name : {"01-move/move.glsl", "02-light/light.glsl"}) {
      write("skeletons/" + name, "skeleton");
      write("steps/" + name, "skeleton");
    }
    for (const std::string name : {"01-move", "02-light"})
      write("tests/cases/" + name + "/cases.json", R"({"schema": 1, "step": ")" + name + R"(",
        "defaults": {"scene": "any", "asked": "A picture.", "hint": "Look.", "rejects": ["x"], "points": 5},
        "cases": [{"name": "a", "title": "A"}, {"name": "b", "title": "B"}]})");
  }
  void write(const std::string& name, const std::string& text) const { write_file(root.path() / name, text); }
  void check(const CourseStep& step, judge::Status b) {
    judge::StepResult result{.step = step.name, .title = {}, .score = b == judge::Status::passed ? 10.0 : 5.0};
    result.cases.push_back({.name = "a", .status = judge::Status::passed});
    result.cases.push_back({.name = "b", .status = b});
    change_progress(folders.progress(), [&](ProgressRecord& record) {
      record_check(record, result, digest_of_files(folders.steps() / step.name, step.files));
    });
  }
  std::map<std::string, std::string> states() const { return unfinished_steps(folders, course, owners); }
  std::string words() const { return about_unfinished(folders, course[2], states()); }
};

using States = std::map<std::string, std::string>;

}  // namespace

TEST_CASE("the earlier steps of one's own that do not pass are named with their state") {
  TwoStepCourse c;
  CHECK(c.states() == States{{"01-move", "untouched"}, {"02-light", "untouched"}});
  c.write("steps/01-move/move.glsl", "mine");
  CHECK(c.states()["01-move"] == "not checked yet");
  c.check(c.course[0], judge::Status::failed);
  CHECK(c.states()["01-move"] == "5/10");
  c.check(c.course[0], judge::Status::passed);
  CHECK(c.states() == States{{"02-light", "untouched"}});
  c.write("steps/01-move/move.glsl", "edited");
  CHECK(c.states()["01-move"] == "passed, edited since");

  c.owners["01-move"] = Owner::solution;
  CHECK(c.states() == States{{"02-light", "untouched"}});
  c.write("steps/02-light/light.glsl", "mine");
  std::filesystem::remove(c.folders.case_file("02-light"));
  CHECK(c.states() == States{{"02-light", "without cases here"}});
}

TEST_CASE("the first thing to do is to check the first of them") {
  TwoStepCourse c;
  CHECK(mentions(c.words(), {"03-shadow", "01-move (untouched), 02-light (untouched)", "First: ./atelier check 01"}));
  std::filesystem::remove(c.folders.case_file("01-move"));
  CHECK(mentions(c.words(), {"First finish 01-move", "steps/01-move"}));
  c.write("solutions/01-move/move.glsl", "the solution");  // which --earlier mine leaves unused
  CHECK(mentions(c.words(), {"Leave out --earlier mine"}));
  c.owners.clear();
  CHECK(c.words().empty());
}
