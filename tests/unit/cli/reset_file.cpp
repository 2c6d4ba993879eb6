#include "cli/student/reset_file.hpp"

#include "base/file.hpp"
#include "base/sealed.hpp"
#include "catch.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

const std::vector<CourseStep> course_of_files = {{.name = "01-move", .files = {"move.cpp", "common.glsl"}},
                                                 {.name = "02-light", .files = {"light.cpp", "common.glsl"}}};

std::string text_of(const std::filesystem::path& file) {
  return read_file(file);
}

}  // namespace

TEST_CASE("a student's file is found by its path, its step or its name") {
  const ProjectFolders folders{.root = "/course", .build = {}};
  struct Row {
    const char *text, *file;
  };
  for (const Row& row : {Row{"02/light.cpp", "02-light/light.cpp"},
                         {"light/light.cpp", "02-light/light.cpp"},
                         {"steps/02-light/light.cpp", "02-light/light.cpp"},
                         {"./steps/02-light/light.cpp", "02-light/light.cpp"},
                         {"/course/steps/02-light/light.cpp", "02-light/light.cpp"},
                         {"move.cpp", "01-move/move.cpp"},
                         {"01/common.glsl", "01-move/common.glsl"}}) {
    INFO(row.text);
    CHECK(find_student_file(folders, course_of_files, row.text).below_steps() == row.file);
  }
  const auto error = [&](const char* text) {
    return error_of([&] { find_student_file(folders, course_of_files, text); });
  };
  CHECK(mentions(error("common.glsl"), {"ambiguous", "01-move/common.glsl or 02-light/common.glsl"}));
  CHECK(mentions(error("mvoe.cpp"), {"mvoe.cpp", "01-move/move.cpp"}));
  CHECK(mentions(error("02/move.cpp"), {"02/move.cpp", "02-light/light.cpp"}));
  CHECK(mentions(error("03/light.cpp"), {"03", "no such step"}));
  CHECK(mentions(error("../light.cpp"), {"no such step"}));
  CHECK(mentions(error("/etc/light.cpp"), {"no such step"}));
  CHECK(!error("").empty());
}

TEST_CASE("a reset keeps the old file under an unused name") {
  const TemporaryFolder root;
  const ProjectFolders folders{.root = root.path(), .build = {}};
  const StudentFile file{course_of_files[0], "move.cpp"};
  const auto path = root.path() / "steps/01-move/move.cpp";
  const auto kept = [&](const char* behind) { return std::filesystem::path(path.string() + behind); };
  CHECK(mentions(error_of([&] { reset_file(folders, file); }), {"01-move/move.cpp", "skeletons/", "archive"}));
  write_file(root.path() / "solutions/01-move/move.cpp", seal("a + b;\n"));  // no skeleton can be cut from it
  CHECK(mentions(error_of([&] { reset_file(folders, file); }), {"01-move/move.cpp", "skeletons/", "archive"}));

  write_file(root.path() / "solutions/01-move/move.cpp",
             std::string_view("// >>> student: add\na + b;\n// <<< student\n"));
  CHECK(reset_file(folders, file).changed);  // the file was lost
  CHECK(text_of(path) == "// TODO(01-move): add\n");
  CHECK(!reset_file(folders, file).changed);

  write_file(path, std::string_view("mine"));
  CHECK(reset_file(folders, file).copy == kept(".before-reset"));
  write_file(path, std::string_view("mine again"));
  CHECK(reset_file(folders, file).copy == kept(".before-reset-2"));
  CHECK(text_of(path) == "// TODO(01-move): add\n");
  CHECK(text_of(kept(".before-reset")) == "mine");
  CHECK(text_of(kept(".before-reset-2")) == "mine again");

  // What was handed out comes before what can be cut.
  write_file(root.path() / "skeletons/01-move/move.cpp", std::string_view("handed out"));
  reset_file(folders, file);
  CHECK(text_of(path) == "handed out");
  write_file(root.path() / ".given/01-move/move.cpp", std::string_view("given"));
  reset_file(folders, file);
  CHECK(text_of(path) == "given");
}
