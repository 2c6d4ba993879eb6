#include "cli/student/standing.hpp"

#include "base/file.hpp"
#include "catch.hpp"
#include "cli/student/handout.hpp"

using namespace atelier;
using judge::Status;

namespace {

/// Two steps of two cases: one without points, one with ten.
struct Course {
  TemporaryFolder root;
  ProjectFolders folders{.root = root.path(), .build = root.path() / "build"};
  std::vector<CourseStep> course = {{.name = "00-hello", .title = "Hello", .files = {"a.glsl"}},
                                    {.name = "01-move", .title = "Move", .files = {"a.glsl"}}};
  ProgressRecord record;

  Course() {
    for (const CourseStep& step : course) {
      const std::string points = step.name == "00-hello" ? "0" : "5";
      write_file(folders.case_file(step.name),
                 R"({"schema": 1, "step": ")" + step.name + R"(",
        "defaults": {"scene": "any", "asked": "A picture.", "hint": "Look.", "rejects": ["x"], "points": )" +
                     points + R"(}, "cases": [{"name": "a", "title": "A"}, {"name": "b", "title": "B"}]})");
      write_file(folders.steps() / step.name / "a.glsl", std::string_view("mine"));
    }
  }
  void check(const CourseStep& step, Status b, double score) {
    judge::StepResult result{.step = step.name, .title = {}, .score = score};
    for (const auto& [name, status] : {std::pair{"a", Status::passed}, std::pair{"b", b}}) {
      result.cases.emplace_back().name = name;
      result.cases.back().status = status;
    }
    record_check(record, result, digest_of_files(folders.steps() / step.name, step.files));
  }
  std::vector<Standing> all() const { return standings(folders, course, record); }
};

}  // namespace

TEST_CASE("the progress follows from the last full check and the current files") {
  Course c;
  CHECK(in_words(c.all()[0]) == "not checked yet");
  CHECK(progress_line(c.all(), true) == "00 \u00b7  01 \u00b7");
  CHECK(next_step(c.all())->step.name == "00-hello");

  c.check(c.course[0], Status::failed, 0);
  CHECK(in_words(c.all()[0]) == "1 of 2 cases");
  c.check(c.course[0], Status::passed, 0);
  c.check(c.course[1], Status::failed, 6.5);
  raise_hint_level(c.record, "01-move", "b", 2);
  CHECK(in_words(c.all()[0]) == "passed");
  CHECK(in_words(c.all()[1]) == "6.5/10");
  CHECK(c.all()[1].hints == 2);
  CHECK(c.all()[1].cases_passed == 1);
  CHECK(progress_line(c.all(), true) == "00 \u2713  01 6.5/10");
  CHECK(progress_line(c.all(), false) == "00 +  01 6.5/10");
  CHECK(next_step(c.all())->step.name == "01-move");

  c.check(c.course[1], Status::passed, 10);
  CHECK(next_step(c.all()) == nullptr);
  write_file(c.folders.steps() / "01-move/a.glsl", std::string_view("other"));
  CHECK(in_words(c.all()[1]) == "passed, edited since");
}

TEST_CASE("the goal and the sections to read are quoted from the handout") {
  Course c;
  CHECK(goal_of(c.folders, c.course[0]) == "Hello");
  CHECK(handout_of(c.folders, c.course[0]) == "");
  write_file(c.folders.handouts() / "00-hello.md",
             std::string_view("# Hello\n\nText.\n\n**Afterwards you can** say *hello* in\n`GLSL`.\n\nMore.\n"));
  CHECK(goal_of(c.folders, c.course[0]) == "Afterwards you can say hello in GLSL.");
  CHECK(handout_of(c.folders, c.course[0]) == "handouts/00-hello.md");
  CHECK(further_reading_of(c.folders, c.course[0]) == "");
  write_file(c.folders.handouts() / "01-move.md", std::string_view("# Move\n\n## Further reading\n\n* a book\n"));
  CHECK(goal_of(c.folders, c.course[1]) == "Move");
  CHECK(further_reading_of(c.folders, c.course[1]) == "handouts/01-move.md, \"Further reading\"");
}
