#include "grade/intake/submission.hpp"

#include "base/file.hpp"
#include "catch.hpp"
#include "grade/varied_cases.hpp"
#include "made_archive.hpp"

using namespace atelier;
using namespace atelier::grade;
using atelier::test::error_of;
using atelier::test::Member;
using atelier::test::mentions;
using atelier::test::write_archive;

namespace {

namespace fs = std::filesystem;

const judge::StepFlags flags{.files = {{"01-move", {"move.cpp"}}, {"02-light", {"light.cpp", "light.glsl"}}}};

}  // namespace

TEST_CASE("a submission's name is a valid folder name") {
  const TemporaryFolder folder;
  for (const char* file : {"...zip", "..zip", ".zip"}) {
    INFO(file);
    write_archive(folder.path() / file, {{"01-move/move.cpp", "int a;"}});
    const std::string name = take_submission(flags, folder.path() / file, folder.path() / "copy").name;
    CHECK(name != "");
    CHECK(name != ".");
    CHECK(name != "..");
  }
}

TEST_CASE("a submission is the listed files, copied") {
  const TemporaryFolder folder;
  const fs::path theirs = folder.path() / "ada";
  write_file(theirs / "01-move/move.cpp", std::string_view("int a;"));
  write_file(theirs / "01-move/CMakeLists.txt", std::string_view("execute_process(COMMAND rm)"));
  write_file(theirs / "02-light/light.glsl", std::string_view("b"));
  fs::create_symlink("/etc/passwd", theirs / "02-light/light.cpp");

  const Submission taken = take_submission(flags, theirs, folder.path() / "copy");
  CHECK(taken.name == "ada");
  CHECK(taken.present == std::set<std::string>{"01-move", "02-light"});
  CHECK(read_file(taken.folder / "01-move/move.cpp") == "int a;");
  CHECK(fs::exists(taken.folder / "02-light/light.glsl"));
  CHECK(!fs::exists(taken.folder / "01-move/CMakeLists.txt"));
  CHECK(!fs::exists(taken.folder / "02-light/light.cpp"));
  CHECK(taken.unusable == std::map<std::string, judge::UnusableFiles>{
                              {"02-light", {{"light.cpp", "is a symbolic link, which is not followed"}}}});
  CHECK(taken.notes == std::vector<std::string>{"02-light/light.cpp is a symbolic link, which is not followed"});
}

TEST_CASE("one enclosing folder is accepted") {
  const TemporaryFolder folder;
  write_file(folder.path() / "ada/hw1/01-move/move.cpp", std::string_view("int a;"));
  write_file(folder.path() / "ada/notes/README", std::string_view("x"));
  const Submission taken = take_submission(flags, folder.path() / "ada", folder.path() / "copy");
  CHECK(taken.present == std::set<std::string>{"01-move"});
  CHECK(taken.source == folder.path() / "ada/hw1");
  CHECK(read_file(taken.folder / "01-move/move.cpp") == "int a;");

  write_file(folder.path() / "ada/hw2/02-light/light.cpp", std::string_view("int a;"));
  CHECK(mentions(error_of([&] { take_submission(flags, folder.path() / "ada", folder.path() / "copy"); }),
                 {"'hw1' and 'hw2'"}));
}

TEST_CASE("the steps of the level nearest to the top are taken") {
  const TemporaryFolder folder;
  const fs::path ada = folder.path() / "ada";
  write_file(ada / "a/b/c/01-move/move.cpp", std::string_view("int a;"));
  write_file(ada / "a/b/c/backup/01-move/move.cpp", std::string_view("int old;"));
  write_file(ada / "__MACOSX/01-move/move.cpp", std::string_view("x"));
  write_file(ada / ".git/01-move/move.cpp", std::string_view("x"));
  fs::create_directory_symlink(ada, ada / "a/loop");
  const Submission taken = take_submission(flags, ada, folder.path() / "copy");
  CHECK(taken.source == ada / "a/b/c");
  CHECK(read_file(taken.folder / "01-move/move.cpp") == "int a;");
  write_file(ada / "a/b/d/01-move/move.cpp", std::string_view("int b;"));
  CHECK(mentions(error_of([&] { take_submission(flags, ada, folder.path() / "copy"); }), {"'a/b/c' and 'a/b/d'"}));
}

TEST_CASE("a text in UTF-16 is read, and said") {
  const TemporaryFolder folder;
  using namespace std::string_literals;
  write_file(folder.path() / "ada/01-move/move.cpp", "\xff\xfei\0n\0t\0 \0a\0;\0\n\0"s);
  const Submission taken = take_submission(flags, folder.path() / "ada", folder.path() / "copy");
  CHECK(read_file(taken.folder / "01-move/move.cpp") == "int a;\n");
  CHECK(taken.notes == std::vector<std::string>{"01-move/move.cpp was UTF-16 and is read as UTF-8"});
}

TEST_CASE("a step whose folder is a link is not submitted") {
  const TemporaryFolder folder;
  write_file(folder.path() / "solution/01-move/move.cpp", std::string_view("int a;"));
  fs::create_directories(folder.path() / "ada/02-light");
  fs::create_directory_symlink(folder.path() / "solution/01-move", folder.path() / "ada/01-move");
  const Submission taken = take_submission(flags, folder.path() / "ada", folder.path() / "copy");
  CHECK(taken.present == std::set<std::string>{"02-light"});
  CHECK(taken.skipped == std::map<std::string, std::string>{{"01-move", "is a symbolic link, which is not followed"}});
  CHECK(taken.notes == std::vector<std::string>{"01-move is a symbolic link, which is not followed"});
}

TEST_CASE("the number of notes is limited") {
  const TemporaryFolder folder;
  std::vector<Member> members = {{"01-move/move.cpp", "a"}};
  for (int i = 0; i < 100; ++i) members.push_back({"../" + std::to_string(i), "x"});
  write_archive(folder.path() / "ada.zip", members);
  const Submission taken = take_submission(flags, folder.path() / "ada.zip", folder.path() / "copy");
  REQUIRE(taken.notes.size() == max_notes);
  CHECK(taken.notes.back() == "81 more");
}

TEST_CASE("an archive gives the same submission as its folder") {
  const TemporaryFolder folder;
  write_archive(folder.path() / "ada.zip", {{"ada/01-move/move.cpp", "int a;"}, {"ada/notes.txt", "x"}});
  const Submission taken = take_submission(flags, folder.path() / "ada.zip", folder.path() / "copy");
  CHECK(taken.name == "ada");
  CHECK(taken.present == std::set<std::string>{"01-move"});
  CHECK(read_file(taken.folder / "01-move/move.cpp") == "int a;");
  CHECK(taken.source.empty());
}

TEST_CASE("missing files of a step in an archive are reported with the reason") {
  const TemporaryFolder folder;
  write_archive(folder.path() / "ada.zip", {{"02-light/light.cpp", "", "/etc/passwd"}});
  const Submission taken = take_submission(flags, folder.path() / "ada.zip", folder.path() / "copy");
  CHECK(taken.present == std::set<std::string>{"02-light"});
  CHECK(judge::in_words(taken.unusable.at("02-light")) ==
        "light.cpp is a symbolic link, which is not followed; light.glsl is missing");
}

TEST_CASE("the seed of a submission depends on its files alone") {
  const TemporaryFolder folder;
  int copies = 0;
  const auto seed = [&](const char* place, const char* file, std::string_view text) {
    write_file(folder.path() / place / "01-move" / file, text);
    return seed_of(take_submission(flags, folder.path() / place, folder.path() / std::to_string(copies++)));
  };
  const std::uint64_t ada = seed("ada", "move.cpp", "int a;");
  CHECK(ada == 3671475666805252);  // on every machine
  CHECK(ada <= max_seed);
  CHECK(seed("elsewhere/bob", "move.cpp", "int a;") == ada);
  CHECK(seed("ada", "notes.txt", "not handed in") == ada);
  CHECK(seed("ada", "move.cpp", "int b;") != ada);
}

TEST_CASE("a submission without a step is refused") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "empty");
  write_archive(folder.path() / "other.zip", {{"README", "x"}});
  const auto take = [&](const char* name) {
    return error_of([&] { take_submission(flags, folder.path() / name, folder.path() / "copy"); });
  };
  CHECK(mentions(take("empty"), {"empty", "none of the steps", "01-move"}));
  CHECK(mentions(take("other.zip"), {"other.zip", "none of the steps"}));
  CHECK(mentions(take("nowhere"), {"nowhere", "no such"}));

  write_file(folder.path() / "deep/a/b/01-move/move.cpp", std::string_view("x"));
  CHECK(mentions(take("deep/a/b/01-move"), {"folder of one step", (folder.path() / "deep/a/b").string()}));
  write_file(folder.path() / "stray/src/notes.txt", std::string_view("x"));
  CHECK(mentions(take("stray"), {"none of the steps", "it has src/notes.txt"}));
  fs::create_directories(folder.path() / "linked");
  fs::create_directory_symlink(folder.path() / "deep/a/b/01-move", folder.path() / "linked/01-move");
  CHECK(mentions(take("linked"), {"skipped: 01-move is a symbolic link"}));

  write_archive(folder.path() / "hollow.zip", {{"a/01-move/CMakeLists.txt", "x"}});
  CHECK(mentions(take("hollow.zip"), {"but none of their files"}));
  write_archive(folder.path() / "climbs.zip", {{"../01-move/move.cpp", "x"}});
  CHECK(mentions(take("climbs.zip"), {"skipped: ../01-move/move.cpp leads out"}));
}
