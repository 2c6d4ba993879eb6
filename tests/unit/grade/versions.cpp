// Several versions of one student's work, skeletons, and what a person must look at.
#include "base/file.hpp"
#include "catch.hpp"
#include "grade/intake/class_folder.hpp"
#include "grade/intake/submission.hpp"
#include "made_archive.hpp"

using namespace atelier;
using namespace atelier::grade;
using atelier::test::three_steps;
using atelier::test::write_archive;

namespace {

namespace fs = std::filesystem;

/// Takes the entries of a folder in this order.
Submission take_versions(const fs::path& folder, const std::vector<const char*>& names,
                         const fs::path& skeletons = {}) {
  std::vector<fs::path> sources;
  for (const char* name : names) sources.push_back(folder / name);
  return take_submission(three_steps, sources, folder / "copy", skeletons);
}

using Sentences = std::vector<std::string>;

}  // namespace

TEST_CASE("of a step in several versions the last counts, whole") {
  const TemporaryFolder folder;
  write_archive(folder.path() / "1.zip", {{"02-light-up/light.cpp", "1"}, {"02-light-up/light.glsl", "1"}});
  write_archive(folder.path() / "2.tar.gz", {{"02-light-up/light.cpp", "2"}, {"01-move/move.cpp", "2"}});
  const Submission taken = take_versions(folder.path(), {"1.zip", "2.tar.gz"});
  CHECK(taken.name == "2");
  CHECK(read_file(taken.folder / "01-move/move.cpp") == "2");
  CHECK(read_file(taken.folder / "02-light-up/light.cpp") == "2");
  CHECK_FALSE(fs::exists(taken.folder / "02-light-up/light.glsl"));
  CHECK(taken.notes == Sentences{"02-light-up is in 1.zip too; the newer in 2.tar.gz counts"});
  CHECK(taken.needs_human == Sentences{"02-light-up/light.glsl is missing"});
  CHECK(taken.taken == Sentences{"01-move: move.cpp", "02-light-up: light.cpp"});
}

TEST_CASE("an empty folder is no newer version") {
  const TemporaryFolder folder;
  write_file(folder.path() / "1/01-move/move.cpp", std::string_view("1"));
  fs::create_directories(folder.path() / "2/01-move");
  const Submission taken = take_versions(folder.path(), {"1", "2"});
  CHECK(read_file(taken.folder / "01-move/move.cpp") == "1");
  CHECK(taken.needs_human.empty());
}

TEST_CASE("single files count together, beside archives") {
  const TemporaryFolder folder;
  write_archive(folder.path() / "hw.zip", {{"01-move/move.cpp", "zip"}});
  write_file(folder.path() / "light.cpp", std::string_view("c"));
  write_file(folder.path() / "light-1.cpp", std::string_view("c2"));
  write_file(folder.path() / "light.glsl", std::string_view("g"));
  write_file(folder.path() / "report.pdf", std::string_view("x"));
  const Submission taken =
      take_versions(folder.path(), {"light.cpp", "hw.zip", "light.glsl", "light-1.cpp", "report.pdf"});
  CHECK(taken.present == std::set<std::string>{"01-move", "02-light-up"});
  CHECK(read_file(taken.folder / "02-light-up/light.cpp") == "c2");
  CHECK(taken.notes ==
        Sentences{"light.cpp was handed in twice; light-1.cpp counts", "02-light-up is read from the top"});
  CHECK(taken.ignored == Sentences{"report.pdf"});
  CHECK(taken.needs_human.empty());
}

TEST_CASE("skeletons that nobody has touched are named, up to line ends, marks and blanks at the ends") {
  const TemporaryFolder folder;
  const fs::path skeletons = folder.path() / "skeletons", ada = folder.path() / "ada";
  write_file(skeletons / "01-move/move.cpp", std::string_view("int a;\n\nint b;\n"));
  write_file(skeletons / "02-light-up/light.cpp", std::string_view("c\n"));
  write_file(skeletons / "02-light-up/light.glsl", std::string_view("g\n"));
  write_file(skeletons / "03-cast-shadows/shadows.cpp", std::string_view("s\n"));
  write_file(ada / "01-move/move.cpp", std::string_view("\xef\xbb\xbfint a;\r\n  \r\nint b;  "));
  write_file(ada / "02-light-up/light.cpp", std::string_view("c\n"));
  write_file(ada / "02-light-up/light.glsl", std::string_view("better\n"));
  fs::create_directories(ada / "03-cast-shadows");
  CHECK(take_versions(folder.path(), {"ada"}, skeletons).untouched == std::set<std::string>{"01-move"});
  CHECK(take_versions(folder.path(), {"ada"}).untouched.empty());
  write_file(ada / "02-light-up/light.glsl", std::string_view("g"));
  CHECK(take_versions(folder.path(), {"ada"}, skeletons).untouched == std::set<std::string>{"01-move", "02-light-up"});
  write_file(ada / "02-light-up/choices.txt", std::string_view("own\n"));  // the skeleton has none
  CHECK(take_versions(folder.path(), {"ada"}, skeletons).untouched == std::set<std::string>{"01-move"});
}

TEST_CASE("a changed copy counts before an untouched one, wherever both are") {
  const TemporaryFolder skeletons;
  write_file(skeletons.path() / "01-move/move.cpp", std::string_view("given\n"));
  write_file(skeletons.path() / "02-light-up/light.cpp", std::string_view("c\n"));
  write_file(skeletons.path() / "02-light-up/light.glsl", std::string_view("g\n"));
  for (const char* solved :
       {"01-move (solved)/move.cpp", "01-move - Kopie/move.cpp", "move/move.cpp", "move.cpp", "01-move/src/move.cpp",
        "my/deep/folder/01-move/move.cpp", "01-move/move (1).cpp", "solution.zip", "build/move.cpp"})
    for (const char* front : {"", "steps/"}) {
      INFO(front << solved);
      const TemporaryFolder folder;
      write_file(folder.path() / "ada" / front / "01-move/move.cpp", std::string_view("given\r\n"));
      const fs::path file = folder.path() / "ada" / solved;
      if (file.extension() == ".zip")
        write_archive(file, {{"move.cpp", "solved"}});
      else
        write_file(file, std::string_view("solved"));
      const Submission taken = take_versions(folder.path(), {"ada"}, skeletons.path());
      CHECK(taken.untouched.empty());
      CHECK(read_file(taken.folder / "01-move/move.cpp") == "solved");
      CHECK_FALSE(taken.notes.empty());
      if (std::string_view(solved).starts_with("build/")) CHECK_FALSE(taken.needs_human.empty());
    }
  const TemporaryFolder folder;
  write_file(folder.path() / "ada/02-light-up/light.cpp", std::string_view("c\n"));
  write_file(folder.path() / "ada/02-light-up/light.glsl", std::string_view("g\n"));
  write_file(folder.path() / "ada/light.cpp", std::string_view("solved"));
  const Submission taken = take_versions(folder.path(), {"ada"}, skeletons.path());
  CHECK(read_file(taken.folder / "02-light-up/light.cpp") == "solved");
  CHECK(read_file(taken.folder / "02-light-up/light.glsl") == "g\n");
}

TEST_CASE("of two folders of steps the one with changed files counts, step by step, also if its name is older") {
  const TemporaryFolder folder;
  const fs::path skeletons = folder.path() / "skeletons", ada = folder.path() / "ada";
  for (const char* file : {"01-move/move.cpp", "03-cast-shadows/shadows.cpp"})
    for (const fs::path& place : {skeletons, ada / "v1", ada / "v2"})
      write_file(place / file, std::string_view("given\n"));
  write_file(ada / "v1/01-move/move.cpp", std::string_view("solved"));
  write_file(ada / "v2/03-cast-shadows/shadows.cpp", std::string_view("solved too"));
  const Submission taken = take_versions(folder.path(), {"ada"}, skeletons);
  CHECK(taken.untouched.empty());
  CHECK(read_file(taken.folder / "01-move/move.cpp") == "solved");
  CHECK(read_file(taken.folder / "03-cast-shadows/shadows.cpp") == "solved too");
  CHECK_FALSE(taken.needs_human.empty());
}

TEST_CASE("a person is told of files beside an untouched step") {
  const TemporaryFolder folder;
  const fs::path skeletons = folder.path() / "skeletons", ada = folder.path() / "ada";
  write_file(skeletons / "01-move/move.cpp", std::string_view("given\n"));
  write_file(ada / "01-move/move.cpp", std::string_view("given\n"));
  write_file(ada / "copy/move.cpp", std::string_view("given\n"));
  CHECK(take_versions(folder.path(), {"ada"}, skeletons).needs_human.empty());
  write_file(ada / "mine/move_solved.cpp", std::string_view("m"));
  write_file(ada / "solved.rar", std::string_view("Rar!\x1a\x07"));
  const Submission taken = take_versions(folder.path(), {"ada"}, skeletons);
  CHECK(taken.untouched == std::set<std::string>{"01-move"});
  REQUIRE(taken.needs_human.size() == 2);
  CHECK(taken.needs_human[0] == "01-move is as in the skeleton, but mine/move_solved.cpp could be work on it");
  CHECK(taken.needs_human[1].starts_with("solved.rar is a RAR archive"));
  CHECK(taken.needs_human[1].ends_with(", while 01-move is as in the skeleton"));
}

TEST_CASE("the skeleton handed in after a changed step does not count, and a person is asked") {
  const TemporaryFolder folder;
  const fs::path skeletons = folder.path() / "skeletons";
  write_file(skeletons / "01-move/move.cpp", std::string_view("given\n"));
  write_archive(folder.path() / "1.zip", {{"01-move/move.cpp", "solved"}});
  write_archive(folder.path() / "2.zip", {{"01-move/move.cpp", "given"}});
  const Submission taken = take_versions(folder.path(), {"1.zip", "2.zip"}, skeletons);
  CHECK(taken.untouched.empty());
  CHECK(read_file(taken.folder / "01-move/move.cpp") == "solved");
  CHECK(taken.notes == Sentences{"01-move is as in the skeleton in 2.zip; the changed one in 1.zip counts"});
  CHECK(taken.needs_human ==
        Sentences{"01-move was handed in changed in 1.zip and later, in 2.zip, as in the skeleton; the changed one "
                  "counts, unless the student meant to withdraw it"});
  write_file(folder.path() / "move.cpp", std::string_view("solved"));
  write_file(folder.path() / "move-1.cpp", std::string_view("given"));
  const Submission loose = take_versions(folder.path(), {"move.cpp", "move-1.cpp"}, skeletons);
  CHECK(read_file(loose.folder / "01-move/move.cpp") == "solved");
  CHECK(loose.needs_human ==
        Sentences{"move.cpp was handed in twice; move-1.cpp, the later, is as in the skeleton, and "
                  "move.cpp counts"});
}

TEST_CASE("nothing in the sources is an exception") {
  const TemporaryFolder folder;
  write_file(folder.path() / "a.rar", std::string_view("Rar!"));
  write_file(folder.path() / "bomb/01-move/move.cpp", std::string_view("m"));
  write_archive(folder.path() / "bomb/big.zip", {{"02-light-up/light.cpp", std::string(900'000, 'x')}});
  fs::create_symlink("/etc", folder.path() / "link");
  fs::create_directories(folder.path() / "empty");
  const Submission taken = take_versions(folder.path(), {"a.rar", "nowhere", "link", "empty", "bomb"});
  CHECK(taken.present == std::set<std::string>{"01-move"});
  REQUIRE(taken.needs_human.size() == 4);
  CHECK(taken.needs_human[0].starts_with("a.rar is a RAR archive"));
  CHECK(taken.needs_human[1] == "nowhere is missing");
  CHECK(taken.needs_human[2] == "link is a symbolic link, which is not followed");
  CHECK(taken.needs_human[3] == "empty is empty: nothing was handed in");
  REQUIRE(taken.notes.size() == 1);
  CHECK(taken.notes[0].starts_with("big.zip 02-light-up/light.cpp inflates to more than 200 times"));
  CHECK(take_versions(folder.path(), {}).present.empty());
}

TEST_CASE("a damaged archive gives the right files or a sentence, never wrong files and no exception") {
  const TemporaryFolder folder;
  const std::string inner = test::archive_bytes("a.zip", {{"02-light-up/light.cpp", "c"}, {"light.glsl", "g"}});
  for (const char* name : {"a.zip", "a.tar.gz", "a.7z"}) {
    const std::string whole = test::archive_bytes(name, {{"hw/01-move/move.cpp", "m"}, {"hw/in.zip", inner}});
    for (std::size_t i = 0; i < whole.size(); i += 3) {
      INFO(name << ", byte " << i);
      std::string broken = whole;
      broken[i] = char(broken[i] ^ 0x55);
      write_file(folder.path() / name, std::string_view(broken));
      const Submission taken = take_versions(folder.path(), {name});
      const fs::path move = taken.folder / "01-move/move.cpp";
      if (fs::exists(move)) CHECK(read_file(move) == "m");
      if (taken.present.empty()) CHECK_FALSE(taken.needs_human.empty());
      fs::remove_all(taken.folder);
      CHECK_NOTHROW(is_class(three_steps, {folder.path() / name}));
    }
  }
}

TEST_CASE("archives in archives are bounded") {
  const TemporaryFolder folder;
  std::string inner = test::archive_bytes("a.zip", {{"01-move/move.cpp", "m"}});
  for (int level = 0; level < 6; ++level) inner = test::archive_bytes("a.zip", {{"in.zip", inner}});
  write_file(folder.path() / "deep.zip", inner);
  const Submission deep = take_versions(folder.path(), {"deep.zip"});
  CHECK(deep.present.empty());
  REQUIRE_FALSE(deep.needs_human.empty());
  CHECK(test::mentions(deep.needs_human[0],
                       {"deep.zip: in.zip/in.zip/in.zip is not read: archives are read to 3 levels"}));

  for (int i = 0; i < 50; ++i)
    write_archive(folder.path() / "many" / (std::to_string(100 + i) + ".zip"), {{"notes.txt", "x"}});
  const Submission many = take_versions(folder.path(), {"many"});
  CHECK(many.needs_human == Sentences{"many: only the first 32 archives are read"});
}
