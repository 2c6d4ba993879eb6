// The files of a student's folder that are submitted.
#include "cli/student/own_files.hpp"

#include "base/file.hpp"
#include "base/sealed.hpp"
#include "catch.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

namespace fs = std::filesystem;

const CourseStep handed_in{
    .name = "01-move", .title = "Move", .files = {"move.cpp", "move.glsl"}, .headers = {}, .uses = {}};

struct Home {
  TemporaryFolder folder;
  ProjectFolders folders{.root = folder.path(), .build = folder.path() / "build"};

  Home() {
    write("steps/01-move/move.cpp", "int a;\n");
    write("steps/01-move/move.glsl", "float b;\n");
    write("steps/01-move/move.hpp", "the contract");
    write("steps/01-move/move.cpp.before-merge", "old");
  }
  void write(const std::string& name, const std::string& text) const { write_file(folder.path() / name, text); }
  fs::path mine(const char* file) const { return folders.steps() / "01-move" / file; }
};

}  // namespace

TEST_CASE("exactly the student's files are submitted") {
  const Home home;
  const grade::PackedFiles files = read_own_files(home.folders, handed_in);
  REQUIRE(files.size() == 2);
  CHECK(files.at("01-move/move.cpp").bytes == "int a;\n");
  CHECK(files.at("01-move/move.glsl").bytes == "float b;\n");
}

TEST_CASE("a file that grade would refuse is not submitted") {
  const Home home;
  const auto error = [&] { return error_of([&] { read_own_files(home.folders, handed_in); }); };
  fs::remove(home.mine("move.glsl"));
  CHECK(mentions(error(), {"move.glsl", "is missing"}));
  fs::create_symlink("move.cpp", home.mine("move.glsl"));
  CHECK(mentions(error(), {"move.glsl", "regular file"}));
  fs::remove(home.mine("move.glsl"));
  home.write("steps/01-move/move.glsl", std::string(judge::source_limit + 1, 'x'));
  CHECK(mentions(error(), {"move.glsl", "1000000"}));
  home.write("steps/01-move/move.glsl", seal("float b;\n"));
  CHECK(mentions(error(), {"move.glsl", "sealed part of a solution"}));
}
