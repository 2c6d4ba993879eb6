// The contents of a release of a small project.
#include "cli/grader/release_contents.hpp"

#include "base/file.hpp"
#include "base/process.hpp"
#include "base/sealed.hpp"
#include "catch.hpp"
#include "cli/grader/release_leaks.hpp"
#include "cli/grader/visible_cases.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

namespace fs = std::filesystem;

const CourseStep move{
    .name = "01-move", .title = "Move", .files = {"move.cpp", "move.glsl"}, .headers = {}, .uses = {}};
const CourseStep light{
    .name = "02-light", .title = "Light", .files = {"light.glsl"}, .headers = {}, .uses = {"01-move"}};
const std::vector<CourseStep> course = {move, light};

const char* const secret = "return translation * rotation * point;";
const char* const shader_secret = "return max(dot(normal, light), 0.0) * colour;";

std::string marked(const std::string& line) {
  return "int given();\n  // >>> student: write it\n  " + line +
         "\n  // --- skeleton\n  // | return 0;\n  // <<< student\n";
}

const char* const cases_of_move = R"({"schema": 1, "step": "01-move",
"defaults": {"scene": "cube", "rejects": ["backwards"], "points": 2, "asked": "A cube.", "hint": "Look."},
"cases": [
  {"name": "near", "title": "Near", "functions": ["go_near"]},
  {"name": "far-and-secret", "title": "Nobody may see this", "hidden": true, "points": 3, "functions": ["go_in_secret"]},
  {"name": "shown", "title": "Shown", "hidden": false, "points": 1}
]})";
const char* const cases_of_light = R"({"schema": 1, "step": "02-light",
"cases": [{"name": "lit", "title": "Lit", "asked": "Light.", "points": 0,
           "probe": "lit", "inputs": [{"x": 1}], "expected": [[1]]}]})";

/// A project with all that a release takes and all that it must not take.
struct Project {
  TemporaryFolder folder;
  ProjectFolders folders{.root = folder.path(), .build = folder.path() / "build"};

  Project() {
    for (const char* name : {"CMakeLists.txt",
                             "CMakePresets.json",
                             "LICENSE",
                             ".clang-format",
                             ".editorconfig",
                             ".gitignore",
                             "atelier",
                             ".vscode/extensions.json",
                             ".vscode/launch.json",
                             ".vscode/settings.json",
                             "steps/CMakeLists.txt",
                             "steps/renames.txt",
                             "steps/skeletons.sha256",
                             "README.md",
                             "CONTRIBUTING.md",
                             "cmake/steps.cmake",
                             "common/base/file.hpp",
                             "common/notes.txt",
                             "common/base/CMakeLists.txt",
                             "handouts/pictures/01-a.png",
                             "handouts/pictures/02-a.png",
                             "handouts/pictures/frame.png",
                             "handouts/pictures/make.sh",
                             "handouts/plots/01-error.svg",
                             "handouts/plots/01-error.csv",
                             "tests/cases/01-move/measure.json",
                             "handouts/README.md",
                             "tests/CMakeLists.txt",
                             "tests/unit/move.cpp",
                             "tests/cases/README.md",
                             "steps/01-move/move.hpp",
                             "steps/01-move/given/main.cpp",
                             "steps/01-move/given/main.cpp.orig",
                             "steps/01-move/given/truth.hpp",
                             "steps/01-move/given/truth.cpp",
                             "steps/01-move/given/exact_move.cpp",
                             "steps/02-light/given/main.cpp"})
      write(name, name);
    write(".vscode/tasks.json", R"({"tasks": [{"label": "check"}, {"label": "test"}]})");
    write("handouts/README-release.md", "For students.");
    write("handouts/01-move.md", "![a](pictures/01-a.png), ![e](plots/01-error.svg), then [light](02-light.md#top).");
    write("handouts/02-light.md", "![a](pictures/02-a.png), after [moving](01-move.md#top), in [a frame](frame.md).");
    write("handouts/frame.md",
          "![f](pictures/frame.png) of [light](02-light.md), [moving](01-move.md), [paint](03-paint.md), "
          "[docs](../docs/look.md)");
    write("handouts/unlinked.md", "a page that no handout links");
    write("solutions/01-move/move.cpp", marked(secret));
    write("solutions/01-move/move.glsl", "vec3 all_given();\n");
    write("solutions/02-light/light.glsl", marked(shader_secret));
    write("steps/01-move/move.cpp", secret);  // somebody's work: never a skeleton
    write("tests/cases/01-move/cases.json", cases_of_move);
    for (const char* name : {"near", "far-and-secret", "shown"}) {
      for (const char* ending : {".exr", ".json", ".atlas.png"})
        write(std::string("tests/cases/01-move/references/") + name + ending, name);
    }
    write("tests/cases/01-move/hints.json", R"({"schema": 1, "step": "01-move", "functions": {
      "go_near": ["Go.", "Near."], "go_in_secret": ["Hide.", "Well."]}})");
    write("tests/cases/02-light/cases.json", cases_of_light);
    write("tests/cases/02-light/references/lit.values.json", "{}");
    write("tests/mistakes/01-move/mistakes.json",
          R"([{"name": "backwards", "title": "B", "sentence": "It looks.", "hint": "Look.",
               "patch": "backwards.patch", "spellings": ["backwards.other.patch"]}])");
    for (const char* name :
         {"mistakes/01-move/backwards.patch", "mistakes/01-move/backwards.other.patch", "variants/01-move/loop.patch"})
      write(std::string("tests/") + name, secret);
  }

  void write(const std::string& name, const std::string& text) const { write_file(folder.path() / name, text); }
  Release release(const std::vector<CourseStep>& steps, Earlier earlier = Earlier::none) const {
    return make_release(folders, course, steps, earlier);
  }
};

std::set<std::string> names_of(const Release& release) {
  std::set<std::string> names;
  for (const auto& [name, file] : release.files) names.insert(name);
  return names;
}

const std::set<std::string> always = {"CMakeLists.txt",
                                      "CMakePresets.json",
                                      "LICENSE",
                                      ".clang-format",
                                      ".editorconfig",
                                      ".gitignore",
                                      ".vscode/extensions.json",
                                      ".vscode/launch.json",
                                      ".vscode/settings.json",
                                      ".vscode/tasks.json",
                                      "atelier",
                                      "README.md",
                                      "release.sha256",
                                      "steps/CMakeLists.txt",
                                      "steps/renames.txt",
                                      "cmake/steps.cmake",
                                      "common/base/file.hpp",
                                      "common/base/CMakeLists.txt"};
const std::set<std::string> of_move = {"steps/01-move/given/main.cpp",
                                       "steps/01-move/given/truth.hpp",
                                       "steps/01-move/given/truth.cpp.sealed",
                                       "steps/01-move/given/exact_move.cpp.sealed",
                                       "steps/01-move/move.hpp",
                                       "handouts/01-move.md",
                                       "handouts/pictures/01-a.png",
                                       "handouts/plots/01-error.svg"};
const std::set<std::string> skeletons_of_move = {"skeletons/01-move/move.cpp", "skeletons/01-move/move.glsl"};
const std::set<std::string> cases_files_of_move = {"tests/cases/01-move/hints.json",
                                                   "tests/cases/01-move/measure.json",
                                                   "tests/cases/01-move/cases.json",
                                                   "tests/cases/01-move/references/near.exr",
                                                   "tests/cases/01-move/references/near.json",
                                                   "tests/cases/01-move/references/near.atlas.png",
                                                   "tests/cases/01-move/references/shown.exr",
                                                   "tests/cases/01-move/references/shown.json",
                                                   "tests/cases/01-move/references/shown.atlas.png",
                                                   "tests/mistakes/01-move/mistakes.json"};
const std::set<std::string> of_light = {
    "steps/02-light/given/main.cpp",   "handouts/02-light.md",
    "handouts/pictures/02-a.png",      "handouts/frame.md",
    "handouts/pictures/frame.png",     "skeletons/02-light/light.glsl",
    "tests/cases/02-light/cases.json", "tests/cases/02-light/references/lit.values.json"};

const std::set<std::string> stand_in_of_move = {"solutions/01-move/libstep.so", "solutions/01-move/move.glsl"};

std::set<std::string> operator+(std::set<std::string> a, const std::set<std::string>& b) {
  a.insert(b.begin(), b.end());
  return a;
}

bool anywhere(const Release& release, const std::string& text) {
  for (const auto& [name, file] : release.files)
    if (name.find(text) != name.npos || file.bytes.find(text) != file.bytes.npos) return true;
  return false;
}

}  // namespace

TEST_CASE("a release contains exactly its list") {
  const Project project;
  SECTION("one step") {
    const Release release = project.release({move});
    CHECK(names_of(release) == always + of_move + skeletons_of_move + cases_files_of_move);
    CHECK(release.earlier.empty());
    CHECK(release.cases == 2);
    CHECK(release.points == 3);
    CHECK(release.hidden == 1);
    CHECK(release.hidden_points == 3);
    CHECK(release.solutions == 3);
    CHECK(release.patches == 3);
    CHECK(release.files.at("atelier").executable);
    CHECK_FALSE(release.files.at("LICENSE").executable);
    CHECK(release.files.at("README.md").bytes == "For students.");
    CHECK(nlohmann::json::parse(release.files.at(".vscode/tasks.json").bytes) ==
          nlohmann::json::parse(R"({"tasks": [{"label": "check"}]})"));
    CHECK(release.files.at("skeletons/01-move/move.cpp").bytes ==
          "int given();\n  // TODO(01-move): write it\n  return 0;\n");
    CHECK(mentions(release.files.at("handouts/01-move.md").bytes,
                   {"![a](pictures/01-a.png), ![e](plots/01-error.svg), then light."}));
  }
  SECTION("a step that uses another") {
    const Release release = project.release({light});
    CHECK(names_of(release) == always + of_move + skeletons_of_move + of_light);
    CHECK(release.earlier == std::vector<std::string>{"01-move"});
    CHECK(mentions(release.files.at("handouts/02-light.md").bytes, {"[moving](01-move.md#top)"}));
    CHECK(mentions(release.files.at("handouts/frame.md").bytes,
                   {"of [light](02-light.md), [moving](01-move.md), paint, docs"}));
  }
  SECTION("all") {
    const Release release = project.release(course);
    CHECK(names_of(release) == always + of_move + skeletons_of_move + cases_files_of_move + of_light);
    CHECK(release.earlier.empty());
  }
  SECTION("with the earlier solution") {
    const Release release = project.release({light}, Earlier::source);
    CHECK(names_of(release) == always + of_move + of_light +
                                   std::set<std::string>{"solutions/01-move/move.cpp", "solutions/01-move/move.glsl"});
    CHECK(release.solutions == 1);
    CHECK(anywhere(release, secret));
    CHECK_FALSE(anywhere(release, ">>> student"));
  }
  SECTION("with the earlier solution compiled") {
    project.write("build/implementations/solutions/01-move/libstep.so", read_file("/proc/self/exe"));
    const Release release = project.release({light}, Earlier::library);
    CHECK(names_of(release) == always + of_move + of_light + stand_in_of_move);
    CHECK(release.carried == std::vector<std::string>{"01-move"});
    const std::string& library = release.files.at("solutions/01-move/libstep.so").bytes;
    CHECK(
        library.starts_with("\x7f"
                            "ELF"));
    CHECK(library.size() < read_file("/proc/self/exe").size());  // without debug information
    const std::string& shader = release.files.at("solutions/01-move/move.glsl").bytes;
    CHECK(is_sealed(shader));
    CHECK(unsealed(shader) == "vec3 all_given();\n");
  }
  SECTION("with compiled solutions of steps that are released too") {
    project.write("build/implementations/solutions/01-move/libstep.so", read_file("/proc/self/exe"));
    Release release = project.release(course, Earlier::library);
    CHECK(names_of(release) ==
          always + of_move + skeletons_of_move + cases_files_of_move + of_light + stand_in_of_move);
    CHECK(release.earlier.empty());
    CHECK(release.carried == std::vector<std::string>{"01-move"});
    CHECK(release.solutions == 3);
    release.files.erase("solutions/01-move/libstep.so");  // this program, which has the secret's text
    CHECK_FALSE(anywhere(release, shader_secret));
    CHECK_FALSE(anywhere(release, secret));
  }
}

TEST_CASE("a release contains nothing of hidden cases, solutions and patches") {
  const Release release = Project().release(course);
  for (const char* trace : {"far-and-secret", "go_in_secret", "Nobody may see this", "\"hidden\"", secret,
                            shader_secret, ".patch", "spelling", "loop", ">>> student", "a mistake that is no more"}) {
    INFO(trace);
    CHECK_FALSE(anywhere(release, trace));
  }
  CHECK(anywhere(release, "Shown"));
  CHECK(anywhere(release, "go_near"));
  CHECK(anywhere(release, "It looks."));
}

TEST_CASE("a case file without hidden cases is copied unchanged") {
  const Project project;
  CHECK(visible_cases(project.folders.case_file("02-light")).text == cases_of_light);
}

TEST_CASE("a solution line in any file stops a release") {
  const Project project;
  SECTION("in a hint of a mistake") {
    project.write(
        "tests/mistakes/01-move/mistakes.json",
        R"([{"name": "backwards", "title": "B", "sentence": "It looks.", "hint": ")" + std::string(secret) + R"("}])");
    CHECK(mentions(error_of([&] { project.release({move}); }), {"mistakes.json", secret, "nothing was released"}));
  }
  SECTION("of a step that is not even released") {
    project.write("cmake/steps.cmake", std::string("# ") + shader_secret);
    CHECK(mentions(error_of([&] { project.release({move}); }), {"cmake/steps.cmake", shader_secret}));
  }
  SECTION("quoted in a handout") {
    project.write("handouts/01-move.md", secret);
    CHECK(mentions(error_of([&] { project.release({move}); }), {"01-move.md", secret}));
  }
  SECTION("unless it is in the given code") {
    project.write("common/given.hpp", secret);
    CHECK(error_of([&] { project.release({move}); }).empty());
  }
  SECTION("also if it is in a second answer, which is sealed") {
    project.write("steps/01-move/given/truth.cpp", secret);
    const Release release = project.release({move});
    CHECK(unsealed(release.files.at("steps/01-move/given/truth.cpp.sealed").bytes) == secret);
    CHECK_FALSE(anywhere(release, secret));
    project.write("cmake/steps.cmake", secret);
    CHECK(mentions(error_of([&] { project.release({move}); }), {"cmake/steps.cmake", secret}));
  }
  SECTION("unless it is too short") {
    project.write("solutions/01-move/move.cpp", marked("return false;"));
    project.write("cmake/steps.cmake", "return false;");
    CHECK(error_of([&] { project.release({move}); }).empty());
  }
}

TEST_CASE("untracked files are not released") {
  const Project project;
  const auto git = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"git", "-C", project.folder.path().string()});
    return run_process({.arguments = arguments}).ok();
  };
  try {
    if (!git({"init", "--quiet"})) SKIP_TEST("git makes no working tree here");
  } catch (const Error&) {
    SKIP_TEST("no git");
  }
  REQUIRE(git({"add", "."}));
  project.write("steps/01-move/given/old_solution.cpp", "anything");
  project.write("common/base/scratch.hpp", "anything");
  const Release release = project.release({move});
  CHECK(release.untracked ==
        std::vector<std::string>{"common/base/scratch.hpp", "steps/01-move/given/old_solution.cpp"});
  CHECK(names_of(release) == always + of_move + skeletons_of_move + cases_files_of_move);
}

TEST_CASE("an incomplete project cannot be released") {
  struct Row {
    const char *name, *file, *text, *why;  ///< no text: the file is removed
  };
  const Row rows[] = {
      {"no solution", "solutions/02-light/light.glsl", nullptr, "needs the whole project"},
      {"no licence", "LICENSE", nullptr, "LICENSE"},
      {"no reference", "tests/cases/01-move/references/near.exr", nullptr, "near.exr"},
      {"no sidecar", "tests/cases/01-move/references/near.json", nullptr, "near.json"},
      {"no picture of a handout", "handouts/pictures/01-a.png", nullptr, "01-a.png"},
      {"broken marks", "solutions/01-move/move.cpp", "// >>> student: x\n", "not closed"},
      {"only hidden cases", "tests/cases/01-move/cases.json",
       R"({"schema": 1, "step": "01-move", "cases": [{"name": "a", "title": "A", "asked": "A.",
           "points": 0, "scene": "cube", "hidden": true}]})",
       "every case is hidden"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const Project project;
    fs::remove(project.folder.path() / row.file);
    if (row.text != nullptr) project.write(row.file, row.text);
    CHECK(mentions(error_of([&] { project.release({move}); }), {row.why}));
  }
  CHECK(mentions(error_of([&] { Project().release({light}, Earlier::library); }), {"libstep.so", "build the project"}));
}
