// Steps in unexpected places: what honest students hand in.
#include "grade/intake/step_places.hpp"

#include <algorithm>

#include "base/file.hpp"
#include "catch.hpp"
#include "grade/intake/submission.hpp"
#include "made_archive.hpp"

using namespace atelier;
using namespace atelier::grade;
using atelier::test::archive_bytes;
using atelier::test::error_of;
using atelier::test::Member;
using atelier::test::mentions;
using atelier::test::three_steps;
using atelier::test::write_archive;

namespace {

namespace fs = std::filesystem;

void write_members(const fs::path& folder, const std::vector<Member>& members) {
  for (const Member& member : members) write_file(folder / member.name, std::string_view(member.bytes));
}

/// The copied files with their bytes.
std::map<std::string, std::string> copied(const Submission& submission) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(submission.folder))
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(submission.folder).string()] = read_file(entry.path());
  return files;
}

bool any_mentions(const std::vector<std::string>& sentences, const std::string& words) {
  return std::ranges::any_of(sentences, [&](const std::string& s) { return s.find(words) != std::string::npos; });
}

using Copied = std::map<std::string, std::string>;
const Copied light = {{"02-light-up/light.cpp", "c"}, {"02-light-up/light.glsl", "g"}};

}  // namespace

TEST_CASE("a step is found by its files, in a folder and in an archive, and said") {
  struct Row {
    const char* name;
    std::vector<Member> members;
    Copied taken;
    std::string note;         ///< empty: none at all
    std::string needs_human;  ///< empty: nobody must look at it
  };
  const Row rows[] = {
      {"as it should be", {{"02-light-up/light.cpp", "c"}, {"02-light-up/light.glsl", "g"}}, light, "", ""},
      {"behind many folders",
       {{"a/b/c/d/e/02-light-up/light.cpp", "c"}, {"a/b/c/d/e/02-light-up/light.glsl", "g"}},
       light,
       "",
       ""},
      {"no number", {{"light-up/light.cpp", "c"}, {"light-up/light.glsl", "g"}}, light, "from 'light-up'", ""},
      {"underscores", {{"02_light_up/light.cpp", "c"}, {"02_light_up/light.glsl", "g"}}, light, "'02_light_up'", ""},
      {"capitals", {{"02-Light-Up/light.cpp", "c"}, {"02-Light-Up/light.glsl", "g"}}, light, "'02-Light-Up'", ""},
      {"only a number", {{"2/light.cpp", "c"}, {"2/light.glsl", "g"}}, light, "from '2'", ""},
      {"Step02", {{"Step02/light.cpp", "c"}, {"Step02/light.glsl", "g"}}, light, "from 'Step02'", ""},
      {"another step's number", {{"03/light.cpp", "c"}, {"03/light.glsl", "g"}}, light, "from '03'", ""},
      {"any name", {{"src/light.cpp", "c"}, {"src/light.glsl", "g"}}, light, "02-light-up is read from 'src'", ""},
      {"no folder", {{"light.cpp", "c"}, {"light.glsl", "g"}}, light, "02-light-up is read from the top", ""},
      {"capitals in files", {{"02-light-up/Light.CPP", "c"}, {"02-light-up/light.GLSL", "g"}}, light, "Light.CPP", ""},
      {"endings that the system hides",
       {{"02-light-up/light.cpp.txt", "c"}, {"02-light-up/light.glsl (1).txt", "g"}},
       light,
       "02-light-up/light.cpp is read from '02-light-up/light.cpp.txt'",
       ""},
      {"a browser's second copy",
       {{"02-light-up/light (1).cpp", "c"}, {"02-light-up/light-2.glsl", "g"}},
       light,
       "light (1).cpp",
       ""},
      {"unpacked twice",
       {{"02-light-up/02-light-up/light.cpp", "c"}, {"02-light-up/02-light-up/light.glsl", "g"}},
       light,
       "'02-light-up/02-light-up",
       ""},
      {"files below",
       {{"02-light-up/src/light.cpp", "c"}, {"02-light-up/shaders/light.glsl", "g"}, {"01-move/move.cpp", "m"}},
       {{"01-move/move.cpp", "m"}, {"02-light-up/light.cpp", "c"}, {"02-light-up/light.glsl", "g"}},
       "shaders/light.glsl",
       ""},
      {"files by their kinds",
       {{"src/light.cpp", "c"}, {"shaders/light.glsl", "g"}},
       light,
       "light.",
       "it may be of another version"},
      {"one file beside its folder",
       {{"02-light-up/light.cpp", "c"}, {"light.glsl", "g"}},
       light,
       "light.glsl is read from 'light.glsl'",
       ""},
      {"one step with its name, one without",
       {{"01-move/move.cpp", "m"}, {"light.cpp", "c"}, {"light.glsl", "g"}},
       {{"01-move/move.cpp", "m"}, {"02-light-up/light.cpp", "c"}, {"02-light-up/light.glsl", "g"}},
       "02-light-up is read from the top",
       ""},
      {"a shared name goes with its step",
       {{"x/shadows.cpp", "s"}, {"x/choices.txt", "3"}},
       {{"03-cast-shadows/shadows.cpp", "s"}, {"03-cast-shadows/choices.txt", "3"}},
       "from 'x'",
       ""},
      {"a shared name of two steps is nobody's",
       {{"light.cpp", "c"}, {"light.glsl", "g"}, {"shadows.cpp", "s"}, {"choices.txt", "?"}},
       {{"02-light-up/light.cpp", "c"}, {"02-light-up/light.glsl", "g"}, {"03-cast-shadows/shadows.cpp", "s"}},
       "from the top",
       "choices.txt could belong to 02-light-up or 03-cast-shadows"},
      {"an archive for each step",
       {{"01-move.zip", archive_bytes("a.zip", {{"01-move/move.cpp", "m"}})},
        {"light-up.zip", archive_bytes("a.zip", {{"light.cpp", "c"}, {"light.glsl", "g"}})}},
       {{"01-move/move.cpp", "m"}, {"02-light-up/light.cpp", "c"}, {"02-light-up/light.glsl", "g"}},
       "from 'light-up.zip'",
       ""},
      {"an archive in an archive in a folder",
       {{"hw/all.tar.gz",
         archive_bytes("a.tar.gz", {{"x/in.7z", archive_bytes("a.7z", {{"01-move/move.cpp", "m"}})}})}},
       {{"01-move/move.cpp", "m"}},
       "",
       ""},
      {"the archive beside what was in it",
       {{"01-move/move.cpp", "new"}, {"hw.zip", archive_bytes("a.zip", {{"01-move/move.cpp", "old"}})}},
       {{"01-move/move.cpp", "new"}},
       "",
       ""},
      {"a backup further down",
       {{"hw/01-move/move.cpp", "m"}, {"hw/backup/01-move/move.cpp", "old"}},
       {{"01-move/move.cpp", "m"}},
       "",
       ""},
      {"the whole course",
       {{"steps/01-move/move.cpp", "m"},
        {"skeletons/01-move/move.cpp", "s"},
        {"skeletons/03-cast-shadows/shadows.cpp", "s"}},
       {{"01-move/move.cpp", "m"}},
       "",
       ""},
      {"litter",
       {{"hw/.vs/01-move/move.cpp", "v"},
        {"__MACOSX/hw/01-move/move.cpp", "v"},
        {"hw/01-move/._move.cpp", "v"},
        {"hw/01-move/x64/Debug/move.cpp", "v"},
        {"hw/.DS_Store", "x"},
        {"hw/01-move/move.cpp", "m"}},
       {{"01-move/move.cpp", "m"}},
       "",
       ""},
  };
  for (const Row& row : rows)
    for (const bool packed : {false, true}) {
      INFO(row.name << (packed ? ", packed" : ""));
      const TemporaryFolder folder;
      const fs::path source = folder.path() / (packed ? "ada.zip" : "ada");
      if (packed)
        write_archive(source, row.members);
      else
        write_members(source, row.members);
      const Submission taken = take_submission(three_steps, source, folder.path() / "copy");
      CHECK(copied(taken) == row.taken);
      INFO("notes: " << ::Catch::StringMaker<std::vector<std::string>>::convert(taken.notes));
      CHECK((row.note.empty() ? taken.notes.empty() : any_mentions(taken.notes, row.note)));
      INFO("needs human: " << ::Catch::StringMaker<std::vector<std::string>>::convert(taken.needs_human));
      CHECK((row.needs_human.empty() ? taken.needs_human.empty() : any_mentions(taken.needs_human, row.needs_human)));
      CHECK(taken.unusable.empty());
    }
}

TEST_CASE("a file that a compiler wants is named once: of two copies one counts, and a person is asked") {
  const TemporaryFolder folder;
  write_members(folder.path() / "ada", {{"01-move/move.cpp", "a"}, {"01-move/move (1).cpp", "b"}});
  const Submission taken = take_submission(three_steps, folder.path() / "ada", folder.path() / "copy");
  CHECK(copied(taken) == Copied{{"01-move/move.cpp", "a"}});
  CHECK(any_mentions(taken.needs_human, "'01-move/move (1).cpp' stands for 01-move/move.cpp too"));
}

TEST_CASE("a text beside the file that it could be is not read, and a person is asked") {
  const TemporaryFolder folder;
  write_members(folder.path() / "ada", {{"01-move/move.cpp", "a"}, {"01-move/move.cpp.txt", "b"}});
  const Submission taken = take_submission(three_steps, folder.path() / "ada", folder.path() / "copy");
  CHECK(copied(taken) == Copied{{"01-move/move.cpp", "a"}});
  CHECK(any_mentions(taken.needs_human, "'01-move/move.cpp.txt' stands for 01-move/move.cpp too"));
}

TEST_CASE("an empty file of code is unusable, empty choices are not") {
  const std::vector<Member> members = {{"01-move/move.cpp", ""},
                                       {"02-light-up/light.cpp", "\xef\xbb\xbf"},
                                       {"02-light-up/light.glsl", "g"},
                                       {"02-light-up/choices.txt", ""}};
  const TemporaryFolder folder;
  write_members(folder.path() / "ada", members);
  write_archive(folder.path() / "bob.zip", members);
  for (const char* name : {"ada", "bob.zip"}) {
    INFO(name);
    const Submission taken = take_submission(three_steps, folder.path() / name, folder.path() / "copy" / name);
    CHECK(taken.unusable ==
          std::map<std::string, judge::UnusableFiles>{{"01-move", {{"move.cpp", "is empty (0 bytes)"}}},
                                                      {"02-light-up", {{"light.cpp", "is empty (0 bytes)"}}}});
    CHECK(any_mentions(taken.needs_human, "01-move/move.cpp is empty (0 bytes)"));
  }
}

TEST_CASE("several versions in one folder: the newer by its name counts, and a person is asked") {
  const TemporaryFolder folder;
  write_members(folder.path() / "ada", {{"v2/01-move/move.cpp", "2"},
                                        {"v10/01-move/move.cpp", "10"},
                                        {"old/01-move/move.cpp", "0"},
                                        {"old/03-cast-shadows/shadows.cpp", "0"}});
  // Alone it is an error: the instructor can name one.
  CHECK(mentions(error_of([&] { take_submission(three_steps, folder.path() / "ada", folder.path() / "copy"); }),
                 {"has steps in two folders, 'old' and 'v10'; name one of them"}));
  const Submission taken =
      take_submission(three_steps, std::vector<fs::path>{folder.path() / "ada"}, folder.path() / "copy");
  CHECK(copied(taken) == Copied{{"01-move/move.cpp", "10"}, {"03-cast-shadows/shadows.cpp", "0"}});
  CHECK(any_mentions(taken.needs_human, "steps are in 3 folders"));
  CHECK(any_mentions(taken.needs_human, "the one in 'v10' counts"));
}

TEST_CASE("names that are like a step's") {
  for (const char* name :
       {"light-up", "02_light_up", "LightUp", "2", "002", "Step02", "step 2", "hw2", "02-light-up.zip"}) {
    INFO(name);
    CHECK(is_like_step(name, "02-light-up"));
  }
  for (const char* name : {"", "1", "12", "light", "move", "ada2", "v2"}) {
    INFO(name);
    CHECK_FALSE(is_like_step(name, "02-light-up"));
  }
}
