#include "cli/layout.hpp"

#include "base/file.hpp"
#include "base/sealed.hpp"
#include "catch.hpp"
#include "cli/author/skeleton_record.hpp"
#include "cli/search_path.hpp"
#include "cli/student/progress_record.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

const std::vector<CourseStep> course_of_names = {{.name = "00-hello"},
                                                 {.name = "01-transforms"},
                                                 {.name = "02-blinn-phong"},
                                                 {.name = "08-post-processing"},
                                                 {.name = "12-gallery"}};

constexpr const char* flags = R"({
  "compiler": "g++", "compiler_version": "GNU 12", "compile": [], "link": [],
  "titles": {"02-light": "Light", "01-move": "Move"},
  "files": {"02-light": ["light.cpp", "light.glsl"], "01-move": ["move.cpp"]},
  "headers": {"02-light": ["02-light/light.hpp"]},
  "uses": {"02-light": ["01-move"]}})";

}  // namespace

TEST_CASE("a step is found by number, name and part") {
  struct Row {
    const char *text, *name;
  };
  for (const Row& row : {Row{"02", "02-blinn-phong"},
                         {"2", "02-blinn-phong"},
                         {"0", "00-hello"},
                         {"12", "12-gallery"},
                         {"02-blinn-phong", "02-blinn-phong"},
                         {"phong", "02-blinn-phong"},
                         {"post", "08-post-processing"}}) {
    INFO(row.text);
    CHECK(resolve_step(course_of_names, row.text).name == row.name);
  }
  CHECK(mentions(error_of([] { resolve_step(course_of_names, "blin-phong"); }), {"blin-phong", "no such step"}));
  CHECK(mentions(error_of([] { resolve_step(course_of_names, "-"); }), {"could be", "00-hello or 01-transforms"}));
  CHECK(mentions(error_of([] { resolve_step(course_of_names, ""); }), {"no such step"}));
  CHECK(mentions(error_of([] { resolve_step(course_of_names, "99999999999999999999"); }), {"no such step"}));
}

TEST_CASE("several steps are listed in the order of the course, each once") {
  const auto steps = resolve_steps(course_of_names, {"phong", "0", "2"});
  REQUIRE(steps.size() == 2);
  CHECK(steps[0].name == "00-hello");
  CHECK(steps[1].name == "02-blinn-phong");
  CHECK(resolve_steps(course_of_names, {}).size() == course_of_names.size());
}

TEST_CASE("the course is read from what CMake has written") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "step_flags.json";
  write_file(file, std::string_view(flags));
  const auto steps = read_course(file);
  REQUIRE(steps.size() == 2);
  CHECK(steps[0].name == "01-move");
  CHECK(steps[0].uses.empty());
  CHECK(steps[1].title == "Light");
  CHECK(steps[1].number() == "02");
  CHECK(steps[1].files == std::vector<std::string>{"light.cpp", "light.glsl"});
  CHECK(steps[1].uses == std::vector<std::string>{"01-move"});

  write_file(file, std::string_view(R"({"files": {"01-move": ["a.cpp"]}, "titles": {}, "headers": {}, "uses": {}})"));
  CHECK(mentions(error_of([&] { read_course(file); }), {"step_flags.json", "titles", "01-move"}));
  write_file(file, std::string_view("[1]"));
  CHECK(mentions(error_of([&] { read_course(file); }), {"step_flags.json", "object"}));
}

TEST_CASE("the search path starts with the judged code, limited to its own step") {
  const TemporaryFolder root;
  const ProjectFolders folders{.root = root.path(), .build = root.path() / "build"};
  for (const char* name : {"steps/01-move", "steps/02-light", "solutions/01-move", "theirs/02-light"})
    std::filesystem::create_directories(root.path() / name);
  const CourseStep step{.name = "02-light", .uses = {"01-move"}};
  const std::vector<CourseStep> two = {{.name = "01-move", .files = {"move.cpp"}}, step};

  const Owners solution = choose_owners(folders, two, step, "");
  CHECK(solution.at("01-move") == Owner::solution);  // nothing has passed yet
  CHECK(choose_owners(folders, two, step, "mine").at("01-move") == Owner::mine);
  CHECK(mentions(error_of([&] { choose_owners(folders, two, step, "theirs"); }), {"theirs", "mine or solution"}));

  const Implementations path =
      search_path(folders, step, {root.path() / "theirs", root.path() / "not-there"}, solution);
  write_file(root.path() / "theirs/02-light/a.glsl", std::string_view("theirs"));
  write_file(root.path() / "theirs/01-move/a.glsl", std::string_view("an earlier step is not theirs to replace"));
  write_file(root.path() / "solutions/01-move/a.glsl", std::string_view("solution"));
  CHECK(path.find("02-light/a.glsl") == root.path() / "theirs/02-light/a.glsl");
  CHECK(path.find("01-move/a.glsl") == root.path() / "solutions/01-move/a.glsl");

  // What theirs lacks nobody else answers for, but for the shaders that are given with the step.
  for (const char* name : {"solutions/02-light/light.glsl", "steps/02-light/light.glsl",
                           "steps/02-light/given/more.glsl", "solutions/03-far/far.glsl"})
    write_file(root.path() / name, std::string_view("somebody's"));
  write_file(folders.own_implementations() / "02-light/libstep.so", std::string_view("mine"));
  const CourseStep with_files{.name = "02-light", .files = {"light.cpp", "light.glsl"}, .uses = {"01-move"}};
  const Implementations strict = search_path(folders, with_files, {root.path() / "theirs", root.path()}, solution);
  CHECK(strict.find("02-light/light.glsl") == "");
  CHECK(strict.find("02-light/libstep.so") == "");
  CHECK(strict.find("02-light/given/more.glsl") == root.path() / "steps/02-light/given/more.glsl");
  CHECK(strict.find("03-far/far.glsl") == root.path() / "solutions/03-far/far.glsl");

  std::filesystem::create_directories(root.path() / "a=b:c");
  CHECK(mentions(error_of([&] {
                   search_path(folders, with_files, {root.path() / "a=b:c", {}}, solution);
                 }),
                 {"a=b:c", "':'"}));

  std::filesystem::remove_all(root.path() / "solutions");
  CHECK(choose_owners(folders, two, step, "").at("01-move") == Owner::mine);  // the solution is not here
  CHECK(mentions(error_of([&] { choose_owners(folders, two, step, "solution"); }),
                 {"--earlier solution", "no solution of 01-move", "--earlier mine"}));
  CHECK(in_words(solution, "02-light", "yours") ==
        std::map<std::string, std::string>{{"01-move", "solution"}, {"02-light", "yours"}});
}

TEST_CASE("a compiled solution stands in where it can be loaded, and cannot be read") {
  const TemporaryFolder root;
  const ProjectFolders folders{.root = root.path(), .build = root.path() / "build"};
  const CourseStep step{.name = "02-light", .uses = {"01-move"}};
  const std::vector<CourseStep> two = {{.name = "01-move", .files = {"move.cpp", "move.glsl"}}, step};
  const auto owner = [&] { return choose_owners(folders, two, step, "").at("01-move"); };
  const auto library = root.path() / "solutions/01-move/libstep.so";
  const std::string program = read_file("/proc/self/exe");

  write_file(root.path() / "solutions/01-move/move.glsl", seal("float move;"));
  write_file(library, program);
  CHECK(owner() == Owner::solution);
  CHECK_FALSE(is_solution_readable(folders, two[0]));

  std::string foreign = program;
  foreign[18] = char(foreign[18] + 1);  // e_machine: another processor
  write_file(library, foreign);
  CHECK(owner() == Owner::mine);
  write_file(library, std::string_view("short"));
  CHECK(owner() == Owner::mine);
  CHECK(mentions(error_of([&] { choose_owners(folders, two, step, "solution"); }), {"no solution of 01-move"}));

  std::filesystem::remove(library);
  write_file(root.path() / "solutions/01-move/move.cpp", std::string_view("int move;"));
  CHECK_FALSE(is_solution_readable(folders, two[0]));  // its shader is sealed
  write_file(root.path() / "solutions/01-move/move.glsl", std::string_view("float move;"));
  CHECK(is_solution_readable(folders, two[0]));
}

TEST_CASE("a student's own earlier step is used if its current files have passed") {
  const TemporaryFolder root;
  const ProjectFolders folders{.root = root.path(), .build = root.path() / "build"};
  write_file(root.path() / "solutions/01-move/move.cpp", std::string_view("solution"));
  write_file(root.path() / "steps/01-move/move.cpp", std::string_view("mine"));
  write_file(folders.case_file("01-move"), std::string_view(R"({"schema": 1, "step": "01-move",
    "defaults": {"scene": "any", "asked": "A picture.", "points": 0},
    "cases": [{"name": "a", "title": "A"}, {"name": "b", "title": "B"}]})"));
  const CourseStep step{.name = "02-light", .uses = {"01-move"}};
  const std::vector<CourseStep> two = {{.name = "01-move", .files = {"move.cpp"}}, step};
  const auto owner = [&] { return choose_owners(folders, two, step, "").at("01-move"); };
  const auto take_down = [&](judge::Status b) {
    judge::StepResult result{.step = "01-move"};
    result.cases.push_back({.name = "a", .status = judge::Status::passed});
    result.cases.push_back({.name = "b", .status = b});
    ProgressRecord record = read_progress(folders.progress());
    record_check(record, result, digest_of_files(folders.steps() / "01-move", {"move.cpp"}));
    write_progress(folders.progress(), record);
  };

  CHECK(owner() == Owner::solution);
  take_down(judge::Status::failed);
  CHECK(owner() == Owner::solution);
  take_down(judge::Status::passed);
  CHECK(owner() == Owner::mine);
  CHECK(choose_owners(folders, two, step, "solution").at("01-move") == Owner::solution);
  write_file(root.path() / "steps/01-move/move.cpp", std::string_view("mine, edited since"));
  CHECK(owner() == Owner::solution);
  write_file(folders.progress(), std::string_view("{"));
  CHECK(mentions(error_of(owner), {"progress.json", "move it away"}));
}

TEST_CASE("an edited skeleton is distinguished from an untouched one") {
  const TemporaryFolder steps;
  write_file(steps.path() / "01-move/move.cpp", std::string_view("abc"));
  // The digest of "abc" from FIPS 180-4's own example.
  const SkeletonRecord record = {
      {"01-move/move.cpp", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"}};
  CHECK(read_skeleton_record(steps.path()).empty());
  write_skeleton_record(steps.path(), record);
  CHECK(read_skeleton_record(steps.path()) == record);
  CHECK(skeleton_state(steps.path(), record, "01-move/move.cpp") == SkeletonState::untouched);
  write_file(steps.path() / "01-move/move.cpp", std::string_view("abcd"));
  CHECK(skeleton_state(steps.path(), record, "01-move/move.cpp") == SkeletonState::edited);
  CHECK(skeleton_state(steps.path(), record, "01-move/other.cpp") == SkeletonState::missing);

  for (const char* broken : {"abc  x\n", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad x\n",
                             "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad  \n"}) {
    write_file(steps.path() / "skeletons.sha256", std::string_view(broken));
    CHECK(mentions(error_of([&] { read_skeleton_record(steps.path()); }), {"skeletons.sha256:1", "SHA-256"}));
  }
}
