// A new step: names, refused input, and files, which are made all or none.
#include "cli/author/step_template.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "catch.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

namespace fs = std::filesystem;

StepFiles files_of(const std::string& step) {
  return files_of_step(fs::path(ATELIER_SOURCE_DIR) / "templates" / "step", names_of_step(step, ""));
}

/// A project with the steps 01-move and 03-light, and nothing in them.
struct SmallCourse {
  TemporaryFolder folder;
  SmallCourse() {
    for (const char* path : {"steps/01-move", "steps/03-light", "tests/cases/04-left"})
      fs::create_directories(folder.path() / path);
  }
  std::string refused(const std::string& step) const {
    return error_of([&] { refuse_taken(folder.path(), names_of_step(step, ""), files_of(step)); });
  }
};

}  // namespace

TEST_CASE("a step's names follow from its number and name") {
  const StepNames names = names_of_step("13-old-film-2", "");
  CHECK(names.number == "13");
  CHECK(names.name == "old_film_2");
  CHECK(names.type == "OldFilm2");
  CHECK(names.title == "Old film 2");
  CHECK(names_of_step("13-fog", "Fog, and what is in it").title == "Fog, and what is in it");
}

TEST_CASE("invalid step names are refused with what is allowed") {
  const struct {
    const char *step, *title, *says;
  } rows[] = {
      {"", "", "NN-name"},
      {"fog", "", "NN-name"},
      {"13", "", "NN-name"},
      {"3-fog", "", "NN-name"},
      {"13-Fog", "", "small letters"},
      {"13_fog", "", "NN-name"},
      {"13-fog-", "", "NN-name"},
      {"13-2d", "", "NN-name"},
      {"13-fog/../x", "", "NN-name"},
      {"13-a-name-that-goes-on-and-on-and-on", "", "at most 32"},
      {"02-fog", "", "03 or more"},
      {"13-new", "", "reserved name"},
      {"13-fog", "a | b", "--title"},
      {"13-fog", "say \"fog\"", "--title"},
      {"13-fog", "two\nlines", "--title"},
      {"13-fog", " fog", "--title"},
  };
  for (const auto& row : rows) {
    INFO(row.step << ", " << row.title);
    CHECK(mentions(error_of([&] { names_of_step(row.step, row.title); }), {"new-step", row.says}));
  }
}

TEST_CASE("placeholders are filled in, and unknown ones refused") {
  const StepNames names = names_of_step("13-old-film", "");
  CHECK(filled_in("@NUMBER@ @STEP@: @TITLE@, class @TYPE@, a@b @name@", names, "x") ==
        "13 13-old-film: Old film, class OldFilm, a@b @name@");
  CHECK(filled_in("steps/@STEP@/@NAME@.hpp", names, "x") == "steps/13-old-film/old_film.hpp");
  CHECK(mentions(error_of([&] { filled_in("@NAMES@", names, "main.cpp"); }), {"main.cpp", "@NAMES@", "@NAME@"}));
}

TEST_CASE("a new step has all files of a step") {
  const StepFiles files = files_of("13-old-film");
  for (const char* path :
       {"steps/13-old-film/old_film.hpp", "steps/13-old-film/README.md", "steps/13-old-film/given/step.cmake",
        "steps/13-old-film/given/main.cpp", "solutions/13-old-film/old_film.cpp", "solutions/13-old-film/old_film.glsl",
        "tests/cases/13-old-film/cases.json", "tests/cases/13-old-film/hints.json",
        "tests/cases/13-old-film/measure.json", "tests/mistakes/13-old-film/mistakes.json",
        "tests/variants/13-old-film/variants.json", "tests/stability/13-old-film/table.cpp",
        "tests/steps/required_old_film.cpp", "handouts/13-old-film.md", "handouts/pictures/13-old-film.sh",
        "docs/steps/13-old-film.json", "docs/pictures/13-old-film.sh"}) {
    INFO(path);
    CHECK(files.contains(path));
  }
  for (const auto& [path, text] : files) {
    INFO(path);
    CHECK(path.find('@') == path.npos);
    CHECK(std::count(text.begin(), text.end(), '\n') < 400);
  }
  CHECK(mentions(error_of([] { files_of_step("/nowhere", names_of_step("13-fog", "")); }), {"/nowhere", "templates"}));
}

TEST_CASE("an existing step, complete or not, is not overwritten") {
  const SmallCourse project;
  CHECK(project.refused("13-fog") == "");
  CHECK(mentions(project.refused("03-fog"), {"steps/03-light", "number 03", "free one is 05"}));
  CHECK(mentions(project.refused("04-fog"), {"tests/cases/04-left", "number 04"}));
  CHECK(mentions(project.refused("13-light"), {"steps/03-light", "name 'light'"}));
  write_file(project.folder.path() / "handouts/13-fog.md", std::string_view("mine"));
  CHECK(mentions(project.refused("13-fog"), {"handouts/13-fog.md"}));
}

TEST_CASE("a step must be committed before another is created") {
  const SmallCourse project;
  const auto git = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"git", "-C", project.folder.path().string(), "-c", "user.name=a", "-c",
                                         "user.email=a@example.org"});
    return run_process({.arguments = arguments}).ok();
  };
  try {
    if (!git({"init", "--quiet"})) SKIP_TEST("git cannot make a repository here");
  } catch (const Error&) {
    SKIP_TEST("there is no git");
  }
  const std::string made = "steps/05-mist/given/step.cmake";
  write_file(project.folder.path() / made, std::string_view("atelier_step(05-mist)\n"));
  CHECK(mentions(project.refused("13-fog"), {"05-mist", "not committed"}));
  REQUIRE(git({"add", made}));
  CHECK(mentions(project.refused("13-fog"), {"05-mist", "not committed"}));
  REQUIRE(git({"commit", "--quiet", "-m", "Add mist"}));
  CHECK(project.refused("13-fog") == "");
}

TEST_CASE("the files of a step are written all or none, without empty folders") {
  const TemporaryFolder folder;
  write_step(folder.path(), {{"a/b/one.txt", "1"}, {"a/two.txt", "2"}});
  CHECK(read_file(folder.path() / "a/b/one.txt") == "1");
  CHECK(read_file(folder.path() / "a/two.txt") == "2");

  write_file(folder.path() / "file", std::string_view());
  const std::string error = error_of([&] { write_step(folder.path(), {{"c/d/one.txt", "1"}, {"file/two.txt", "2"}}); });
  CHECK(mentions(error, {"nothing was written", "file"}));
  CHECK_FALSE(fs::exists(folder.path() / "c"));
}
