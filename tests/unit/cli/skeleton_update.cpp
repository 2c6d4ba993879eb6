// Updates of a student's files by releases: created, replaced, merged, put beside, never lost.
#include "cli/student/skeleton_update.hpp"

#include <cstdlib>

#include "base/file.hpp"
#include "base/process.hpp"
#include "catch.hpp"
#include "cli/author/skeleton_record.hpp"

using namespace atelier;
using atelier::test::mentions;

namespace {

namespace fs = std::filesystem;

const std::string skeleton = "01-move/move.cpp";

/// A folder in which a release was unpacked.
struct Unpacked {
  TemporaryFolder folder;
  ProjectFolders folders{.root = folder.path(), .build = folder.path() / "build"};

  void release(const std::string& text) const { write_file(folders.skeletons() / skeleton, text); }
  void edit(const std::string& text) const { write_file(mine(), text); }
  std::vector<std::string> update() const { return update_skeletons(folders); }

  fs::path mine() const { return folders.steps() / skeleton; }
  std::string beside(const std::string& ending) const {
    const fs::path path = mine().string() + ending;
    return fs::exists(path) ? read_file(path) : "(none)";
  }
  SkeletonState state() const {
    return skeleton_state(folders.steps(), read_skeleton_record(folders.steps()), skeleton);
  }
};

/// PATH without any program, until the end of the scope.
class NoPrograms {
 public:
  NoPrograms() { ::setenv("PATH", empty_.path().c_str(), 1); }
  ~NoPrograms() { ::setenv("PATH", old_.c_str(), 1); }

 private:
  std::string old_ = std::getenv("PATH");
  TemporaryFolder empty_;
};

bool has_git() {
  try {
    return run_process({.arguments = {"git", "--version"}}).ok();
  } catch (const Error&) {
    return false;
  }
}

const std::string first = "int a;\n\nint move();\n\n// b\n\n// c\n";
const std::string second = "int a = 1;\n\nint move();\n\n// b\n\n// c\n";
const std::string edited = "int a;\n\nint move();\n\n// b\n\n// c: my own\n";
const std::string both = "int a = 1;\n\nint move();\n\n// b\n\n// c: my own\n";
const std::string edited_there = "int a = 2;\n\nint move();\n\n// b\n\n// c\n";

}  // namespace

TEST_CASE("without skeletons there is nothing to do") {
  const Unpacked project;
  CHECK(project.update().empty());
  CHECK(fs::is_empty(project.folder.path()));
}

TEST_CASE("a missing file is created, and again if it was deleted") {
  const Unpacked project;
  project.release(first);
  CHECK(mentions(project.update().at(0), {"steps/01-move/move.cpp"}));
  CHECK(read_file(project.mine()) == first);
  CHECK(project.state() == SkeletonState::untouched);
  CHECK(project.update().empty());

  fs::remove(project.mine());
  CHECK(project.update().size() == 1);
  CHECK(read_file(project.mine()) == first);

  project.edit(edited);
  CHECK(project.update().empty());
  CHECK(read_file(project.mine()) == edited);
  CHECK(project.state() == SkeletonState::edited);
}

TEST_CASE("an untouched file is replaced by the new skeleton") {
  const Unpacked project;
  project.release(first);
  project.update();
  project.release(second);
  CHECK(mentions(project.update().at(0), {"untouched"}));
  CHECK(read_file(project.mine()) == second);
  CHECK(project.state() == SkeletonState::untouched);
  CHECK(project.beside(".before-merge") == "(none)");
}

TEST_CASE("a file that already is the new skeleton is not reported") {
  const Unpacked project;
  project.release(first);
  project.update();
  project.release(second);
  project.edit(second);
  CHECK(project.update().empty());
  CHECK(project.state() == SkeletonState::untouched);
}

TEST_CASE("changes of the student and of the release are merged, and the student's file is kept") {
  if (!has_git()) SKIP_TEST("no git");
  const Unpacked project;
  project.release(first);
  project.update();
  project.edit(edited);
  project.release(second);
  CHECK(mentions(project.update().at(0), {"move.cpp.before-merge"}));
  CHECK(read_file(project.mine()) == both);
  CHECK(project.beside(".before-merge") == edited);
  CHECK(project.update().empty());

  SECTION("the next merge takes the next name") {
    project.release("// a, better still\n\nint move();\n\n// b\n\n// c\n");
    CHECK(mentions(project.update().at(0), {"move.cpp.before-merge-2"}));
    CHECK(project.beside(".before-merge") == edited);
    CHECK(project.beside(".before-merge-2") == both);
  }
  SECTION("a run that is interrupted before recording the given files has the same result") {
    write_file(project.folders.given() / skeleton, first);
    CHECK(project.update().empty());
    CHECK(read_file(project.mine()) == both);
    CHECK(project.beside(".before-merge-2") == "(none)");
  }
}

TEST_CASE("if both have changed the same lines, the new skeleton is put beside the file") {
  const Unpacked project;
  project.release(first);
  project.update();
  project.edit(edited_there);
  project.release(second);
  CHECK(mentions(project.update().at(0), {"move.cpp.new"}));
  CHECK(read_file(project.mine()) == edited_there);
  CHECK(project.beside(".new") == second);
  CHECK(project.beside(".before-merge") == "(none)");
  CHECK(project.update().empty());

  const std::string third = "int a = 3;\n\nint move();\n\n// b\n\n// c\n";
  project.release(third);
  CHECK(mentions(project.update().at(0), {"move.cpp.new-2"}));
  CHECK(read_file(project.mine()) == edited_there);
  CHECK(project.beside(".new") == second);
  CHECK(project.beside(".new-2") == third);
}

TEST_CASE("without git, the new skeleton is put beside an edited file, and replaces an untouched one") {
  const NoPrograms without_git;
  REQUIRE_FALSE(has_git());
  const Unpacked project;
  project.release(first);
  project.update();
  SECTION("edited") {
    project.edit(edited);
    project.release(second);
    CHECK(mentions(project.update().at(0), {"move.cpp.new"}));
    CHECK(read_file(project.mine()) == edited);
    CHECK(project.beside(".new") == second);
    CHECK(project.update().empty());
  }
  SECTION("untouched") {
    project.release(second);
    CHECK(project.update().size() == 1);
    CHECK(read_file(project.mine()) == second);
    CHECK(project.beside(".new") == "(none)");
  }
}

TEST_CASE("a file without a record of its given version is kept") {
  const Unpacked project;  // a release unpacked afresh, and last week's work copied into it
  project.release(second);
  project.edit(edited);
  CHECK(mentions(project.update().at(0), {"move.cpp.new"}));
  CHECK(read_file(project.mine()) == edited);
  CHECK(project.beside(".new") == second);
  CHECK(project.update().empty());
}

TEST_CASE("renamed identifiers are renamed in the student's file, once") {
  const Unpacked project;
  const auto renames = project.folders.steps() / "renames.txt";
  project.release("int move() {\n  return 0;\n}\n\nint stay();\n");
  project.update();
  project.edit("int move() {\n  return helper;\n}\n\nint stay() { return move(); }\n");

  SECTION("with a new skeleton") {
    if (!has_git()) SKIP_TEST("there is no git");
    project.release("// What it does.\nint shift() {\n  return 0;\n}\n\nint stay();\n");
    write_file(renames, std::string_view("01-move move shift\n"));
    CHECK(mentions(project.update().at(0), {"01-move/move.cpp", "before-merge"}));
    CHECK(read_file(project.mine()) ==
          "// What it does.\nint shift() {\n  return helper;\n}\n\nint stay() { return shift(); }\n");
    CHECK(project.beside(".before-merge") == "int move() {\n  return helper;\n}\n\nint stay() { return move(); }\n");
  }
  SECTION("with a skeleton that differs only in the name, without git") {
    const NoPrograms none;
    project.release("int shift() {\n  return 0;\n}\n\nint stay();\n");
    write_file(renames, std::string_view("01-move move shift\n"));
    project.update();
    CHECK(read_file(project.mine()) == "int shift() {\n  return helper;\n}\n\nint stay() { return shift(); }\n");
  }
  SECTION("if only the student's lines contain the name") {
    write_file(renames, std::string_view("01-move helper tool\n"));
    project.update();
    CHECK(read_file(project.mine()) == "int move() {\n  return tool;\n}\n\nint stay() { return move(); }\n");
    project.edit("int move() {\n  return helper;  // mine again\n}\n\nint stay();\n");
    CHECK(project.update().empty());  // the files have been through it: a name of the student's own stays
    CHECK(read_file(project.mine()).find("helper") != std::string::npos);
  }
}

TEST_CASE("if a release changes only comments, the student's lines stay") {
  if (!has_git()) SKIP_TEST("there is no git");
  const Unpacked project;
  project.release("// a\nint move() {\n  // TODO: move\n  return 0;\n}\n");
  project.update();
  project.edit("// a\nint move() {\n  return 1;\n}\n");
  SECTION("the same code") {
    project.release("// a, better\n// still\nint move() {\n  // TODO: move it\n  return 0;\n}\n");
    project.update();
    CHECK(read_file(project.mine()) == "// a, better\n// still\nint move() {\n  return 1;\n}\n");
  }
  SECTION("other code") {
    const std::string code = "// a\nint move() {\n  // TODO: move it\n  return 7;\n}\n";
    project.release(code);
    project.update();
    CHECK(read_file(project.mine()) == "// a\nint move() {\n  return 1;\n}\n");
    CHECK(project.beside(".new") == code);
  }
}
