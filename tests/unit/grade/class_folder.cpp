// Classes as instructors download them from course platforms, and what is no class.
#include "grade/intake/class_folder.hpp"

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

/// A submission of one step.
const std::string& move_zip() {
  static const std::string bytes = archive_bytes("a.zip", {{"hw/01-move/move.cpp", "m"}});
  return bytes;
}

/// The class: written to a folder, or packed as platforms deliver it.
struct Delivery {
  TemporaryFolder folder;
  fs::path source;
  Delivery(const std::vector<Member>& members, bool packed) : source(folder.path() / (packed ? "class.zip" : "class")) {
    if (packed)
      write_archive(source, members);
    else
      for (const Member& member : members) write_file(source / member.name, std::string_view(member.bytes));
    if (!packed) fs::create_directories(source);
  }
  bool is_class() const { return grade::is_class(three_steps, {source}); }
  ClassFolder find(const ClassNaming& naming = {}) const {
    return find_submissions(three_steps, {source}, folder.path() / "unpacked", naming);
  }
  Submission take(const HandedIn& handed) const {
    return take_submission(three_steps, handed.sources, folder.path() / "copy" / handed.student.id);
  }
};

std::vector<std::string> ids_of(const ClassFolder& found) {
  std::vector<std::string> ids;
  for (const HandedIn& handed : found.submissions) ids.push_back(handed.student.id);
  return ids;
}

bool any_says(const std::vector<std::string>& sentences, const std::string& words) {
  return std::ranges::any_of(sentences, [&](const std::string& s) { return s.find(words) != std::string::npos; });
}

using Ids = std::vector<std::string>;

}  // namespace

TEST_CASE("classes of all platforms are recognised, in folders and in one archive, and all their steps are found") {
  struct Row {
    const char* name;
    std::vector<Member> members;
    const char* platform;
    Ids ids;
  };
  const std::string moodle = "_assignsubmission_file_";
  const Row rows[] = {
      {"Moodle, folders",
       {{"Ada L_11" + moodle + "/hw.zip", move_zip()}, {"Bob_12" + moodle + "/01-move/move.cpp", "m"}},
       "moodle",
       {"ada-l-11", "bob-12"}},
      {"Moodle, flat",
       {{"Ada L_11" + moodle + "hw.zip", move_zip()}, {"Bob_12" + moodle + "move.cpp", "m"}},
       "moodle",
       {"ada-l-11", "bob-12"}},
      {"Moodle, one student", {{"Ada L_11" + moodle + "/hw.zip", move_zip()}}, "moodle", {"ada-l-11"}},
      {"Moodle, students of one name",
       {{"Ada_11" + moodle + "/hw.zip", move_zip()}, {"Ada_12" + moodle + "/hw.zip", move_zip()}},
       "moodle",
       {"ada-11", "ada-12"}},
      {"Moodle, behind folders",
       {{"x/y/Ada_11" + moodle + "/hw.zip", move_zip()}, {"x/y/Bob_12" + moodle + "/hw.zip", move_zip()}},
       "moodle",
       {"ada-11", "bob-12"}},
      {"Moodle, in other letters",
       {{"\u5c71\u7530_11" + moodle + "/hw.zip", move_zip()}, {"M\u00fcller_12" + moodle + "/hw.zip", move_zip()}},
       "moodle",
       {"11", "mueller-12"}},
      {"Canvas",
       {{"lovelaceada_1_2_hw.zip", move_zip()}, {"bob_LATE_3_4_hw-1.zip", move_zip()}},
       "canvas",
       {"bob-3", "lovelaceada-1"}},
      {"Canvas, single files", {{"ada_1_2_move.cpp", "m"}, {"bob_3_4_move-1.cpp", "m"}}, "canvas", {"ada-1", "bob-3"}},
      {"Gradescope",
       {{"g/submission_metadata.yml",
         "---\nsubmission_1:\n  :submitters:\n  - :name: Ada\n    :sid: 11\n  :created_at: 1970-01-01 00:00:09 Z\n"},
        {"g/submission_1/move.cpp", "m"},
        {"g/submission_2/01-move/move.cpp", "m"}},
       "gradescope",
       {"2", "ada-11"}},
      {"Gradescope, without metadata",
       {{"submission_1/move.cpp", "m"}, {"submission_2/01-move/move.cpp", "m"}},
       "gradescope",
       {"1", "2"}},
      {"GitHub",
       {{"hw-1-ada/.git/HEAD", "x"},
        {"hw-1-ada/01-move/move.cpp", "m"},
        {"hw-1-bob-c/.git/HEAD", "x"},
        {"hw-1-bob-c/steps/01-move/move.cpp", "m"}},
       "github",
       {"ada", "bob-c"}},
      {"folders", {{"ada/01-move/move.cpp", "m"}, {"bob/move.cpp", "m"}}, "folders", {"ada", "bob"}},
      {"archives of all kinds",
       {{"ada.zip", move_zip()},
        {"bob.tar.gz", archive_bytes("a.tar.gz", {{"01-move/move.cpp", "m"}})},
        {"carl.7z", archive_bytes("a.7z", {{"move.cpp", "m"}})}},
       "folders",
       {"ada", "bob", "carl"}},
      {"numbers of students",
       {{"1234567/01-move/move.cpp", "m"}, {"7654321/01-move/move.cpp", "m"}},
       "folders",
       {"1234567", "7654321"}},
      {"groups of students",
       {{"Group A/ada/01-move/move.cpp", "m"},
        {"Group A/bob/01-move/move.cpp", "m"},
        {"Group B/ada/01-move/move.cpp", "m"},
        {"Group B/carl/01-move/move.cpp", "m"}},
       "folders",
       {"ada", "ada-2", "bob", "carl"}},
      {"names that differ by case",
       {{"Ada/01-move/move.cpp", "m"}, {"ada/01-move/move.cpp", "m"}, {"bob/move.cpp", "m"}},
       "folders",
       {"ada", "ada-2", "bob"}},
      {"reserved and hostile names",
       {{"con/01-move/move.cpp", "m"}, {"\u202egpj.exe/01-move/move.cpp", "m"}, {"-rf ~/01-move/move.cpp", "m"}},
       "folders",
       {"gpj.exe", "rf", "student-con"}},
  };
  for (const Row& row : rows)
    for (const bool packed : {false, true}) {
      INFO(row.name << (packed ? ", packed" : ""));
      const Delivery delivery(row.members, packed);
      CHECK(delivery.is_class());
      const ClassFolder found = delivery.find();
      CHECK(found.platform == std::string(row.platform));
      CHECK(ids_of(found) == row.ids);
      for (const HandedIn& handed : found.submissions) {
        INFO(handed.student.id);
        CHECK(delivery.take(handed).present == std::set<std::string>{"01-move"});
      }
    }
}

TEST_CASE("what one student has handed in is no class") {
  const std::vector<Member> rows[] = {
      {{"01-move/move.cpp", "m"}, {"02-light-up/light.cpp", "c"}, {"03-cast-shadows/shadows.cpp", "s"}},
      {{"ada/01-move/move.cpp", "m"}, {"ada/02-light-up/light.cpp", "c"}},
      {{"move/move.cpp", "m"}, {"light up/light.cpp", "c"}},
      {{"move.zip", move_zip()}, {"cast-shadows.zip", move_zip()}},
      {{"move.cpp", "m"}, {"light.cpp", "c"}},
      {{"v1/01-move/move.cpp", "m"}, {"v2/01-move/move.cpp", "m"}},
      {{"old/01-move/move.cpp", "m"}, {"final/01-move/move.cpp", "m"}},
      {{"ada/01-move/move.cpp", "m"}, {"ada (1)/01-move/move.cpp", "m"}, {"ada - Copy/01-move/move.cpp", "m"}},
      {{"2024-03-05/01-move/move.cpp", "m"}, {"2024-03-06/01-move/move.cpp", "m"}},
      {{"hw1/01-move/move.cpp", "m"}, {"hw2/02-light-up/light.cpp", "c"}},
      {{"ada/hw1/01-move/move.cpp", "m"}, {"ada/notes/report.pdf", "x"}},
      {{"steps/01-move/move.cpp", "m"}, {"skeletons/01-move/move.cpp", "m"}, {"build/01-move/move.cpp", "m"}},
      {{"hw/01-move/move.cpp", "m"}, {"ada_1_2_shot.png", "x"}},
      {{"code/01-move/move.cpp", "m"}, {"homework/02-light-up/light.cpp", "c"}},
      {{"hw7/01-move/move.cpp", "m"}, {"hw8/01-move/move.cpp", "c"}},
      {{"report.pdf", "x"}},
      {{"ada/notes.txt", "x"}, {"bob/notes.txt", "x"}},
  };
  for (const std::vector<Member>& members : rows)
    for (const bool packed : {false, true}) {
      INFO(members[0].name << (packed ? ", packed" : ""));
      CHECK_FALSE(Delivery(members, packed).is_class());
    }
  const TemporaryFolder folder;
  CHECK_FALSE(is_class(three_steps, {folder.path()}));
  CHECK_FALSE(is_class(three_steps, {folder.path() / "nowhere"}));
  CHECK_FALSE(is_class(three_steps, {}));
  CHECK(is_class(three_steps, {folder.path() / "a", folder.path() / "b"}));
}

TEST_CASE("a class in an archive in a folder is found") {
  const Delivery delivery(
      {{"download/all.zip", archive_bytes("a.zip", {{"ada.zip", move_zip()}, {"bob.zip", move_zip()}})}}, false);
  CHECK(is_class(three_steps, {delivery.source / "download"}));
  const ClassFolder found =
      find_submissions(three_steps, {delivery.source / "download"}, delivery.folder.path() / "unpacked");
  CHECK(ids_of(found) == Ids{"ada", "bob"});
}

TEST_CASE("what a platform says about a student is kept") {
  {
    const Delivery delivery({{"ada_LATE_11_2_hw.zip", move_zip()}, {"bob_12_3_hw.zip", move_zip()}}, false);
    const ClassFolder found = delivery.find();
    CHECK(found.submissions[0].late);
    CHECK_FALSE(found.submissions[1].late);
    CHECK(found.submissions[0].student.name == "ada");
    CHECK(found.submissions[0].student.identifier == "11");
    CHECK(found.submissions[0].source == "ada_LATE_11_2_hw.zip");
  }
  {
    const Delivery delivery({{"submission_metadata.yml",
                              "---\nsubmission_1:\n  :submitters:\n  - :name: Ada\n"
                              "  :created_at: 1970-01-01 00:00:09 Z\n"},
                             {"submission_1/move.cpp", "m"},
                             {"notes/x.txt", "x"}},
                            false);
    const ClassFolder found = delivery.find();
    CHECK(found.submissions[0].student.name == "Ada");
    CHECK(found.submissions[0].handed_in == 9);
    CHECK(any_says(found.ignored, "notes is not named as Gradescope"));
  }
  {
    const Delivery delivery({{"\x1b[2J\u202e_1_assignsubmission_file_/move.cpp", "m"}}, false);
    const ClassFolder found = delivery.find();
    CHECK(found.submissions[0].student.name == "\ufffd[2J\ufffd");
    CHECK(found.submissions[0].student.id == "2j-1");
  }
}

TEST_CASE("several files of one student on Canvas: the platform's order decides") {
  const Delivery delivery({{"ada_1_10_hw-1.zip", archive_bytes("a.zip", {{"01-move/move.cpp", "new"}})},
                           {"ada_1_9_hw.zip", archive_bytes("a.zip", {{"01-move/move.cpp", "old"},
                                                                      {"03-cast-shadows/shadows.cpp", "old"}})},
                           {"bob_2_3_light.cpp", "c"},
                           {"bob_2_4_light.glsl", "g"},
                           {"carl_3_1_report.pdf", "x"}},
                          true);
  const ClassFolder found = delivery.find();
  REQUIRE(ids_of(found) == Ids{"ada-1", "bob-2", "carl-3"});
  CHECK(found.submissions[0].needs_human.empty());
  CHECK(any_says(found.submissions[0].notes,
                 "handed in 'hw.zip', 'hw-1.zip'; of a step in several, the one in 'hw-1.zip' counts, the newest"));
  const Submission ada = delivery.take(found.submissions[0]);
  CHECK(read_file(ada.folder / "01-move/move.cpp") == "new");
  CHECK(read_file(ada.folder / "03-cast-shadows/shadows.cpp") == "old");
  CHECK(any_says(ada.notes, "01-move is in hw.zip too; the newer in hw-1.zip counts"));
  CHECK(ada.needs_human.empty());
  const Submission bob = delivery.take(found.submissions[1]);
  CHECK(bob.present == std::set<std::string>{"02-light-up"});
  CHECK(bob.unusable.empty());
  CHECK(any_says(delivery.take(found.submissions[2]).needs_human, "has report.pdf, but none of the steps'"));
}

TEST_CASE("versions of one student beside each other are one submission, for a person to look at") {
  const Delivery delivery({{"ada.zip", move_zip()}, {"ada (1).zip", move_zip()}, {"bob-final.zip", move_zip()}}, false);
  const ClassFolder found = delivery.find();
  REQUIRE(ids_of(found) == Ids{"ada", "bob-final"});
  CHECK(found.submissions[0].sources ==
        std::vector<fs::path>{delivery.source / "ada.zip", delivery.source / "ada (1).zip"});
  CHECK(any_says(found.submissions[0].needs_human, "the one in 'ada (1).zip' counts, the newest by its name"));
  CHECK(found.submissions[1].needs_human.empty());
}

TEST_CASE("a text on Moodle's page is no file; of who has nothing else a person is told") {
  const Delivery delivery({{"Ada_1_assignsubmission_file_/move.cpp", "m"},
                           {"Ada_1_assignsubmission_onlinetext_/onlinetext.html", "x"},
                           {"Bob_2_assignsubmission_onlinetext_/onlinetext.html", "x"},
                           {"grades.csv", "x"}},
                          true);
  const ClassFolder found = delivery.find();
  REQUIRE(ids_of(found) == Ids{"ada-1", "bob-2"});
  CHECK(found.submissions[0].needs_human.empty());
  CHECK(any_says(found.submissions[1].needs_human, "a text on Moodle's page"));
  CHECK(any_says(found.ignored, "grades.csv is not named as Moodle"));
}

TEST_CASE("work whose student is unknown is a submission for a person to look at") {
  struct Row {
    std::vector<Member> members;  ///< the last ones are no work
    Ids ids;
    std::string needs_human;  ///< of the first
  };
  const std::string moodle = "_assignsubmission_file_";
  const Row rows[] = {
      {{{"Ada_1" + moodle + "/move.cpp", "m"}, {"A Late (by email)/main.cpp", "m"}, {"readme.txt", "x"}},
       {"a-late-by-email", "ada-1"},
       "'A Late (by email)' is not named as Moodle names folders"},
      {{{"Dora_1" + moodle + "/move.cpp", "m"}, {"Carl" + moodle + "/x.txt", "m"}, {"skeletons/move.cpp", "x"}},
       {"carl-assignsubmission-file", "dora-1"},
       "whose is it?"},
      {{{"dora_1_2_move.cpp", "m"}, {"emil_3_4_move.cpp", "m"}, {"carl.pdf", "x"}, {"grades.csv", "x"}},
       {"carl.pdf", "dora-1", "emil-3"},
       "'carl.pdf' is not named as Canvas names files"},
      {{{"submission_2/move.cpp", "m"}, {"carl.rar", "Rar!"}, {"pictures/a.png", "x"}},
       {"carl", "2"},
       "'carl.rar' is not named as Gradescope names folders"},
      {{{"emil/move.cpp", "m"}, {"dora/move.cpp", "m"}, {"Build/01-move/move.cpp", "m"}, {"out/a.o", "x"}},
       {"build", "dora", "emil"},
       "'Build' is named as a folder of the course or a compiler"},
  };
  for (const Row& row : rows) {
    INFO(row.members[0].name);
    const ClassFolder found = Delivery(row.members, false).find();
    Ids ids = ids_of(found);
    std::ranges::sort(ids);
    Ids wanted = row.ids;
    std::ranges::sort(wanted);
    CHECK(ids == wanted);
    const auto of = std::ranges::find(found.submissions, row.ids[0], [](const HandedIn& h) { return h.student.id; });
    REQUIRE(of != found.submissions.end());
    CHECK(any_says(of->needs_human, row.needs_human));
  }
}

TEST_CASE("each student of a group on Gradescope has handed in") {
  const Delivery delivery({{"submission_metadata.yml",
                            "---\nsubmission_1:\n  :submitters:\n  - :name: Ada\n    :sid: 11\n"
                            "  - :name: Bob\n    :sid: 12\n  :created_at: 1970-01-01 00:00:09 Z\n"},
                           {"submission_1/01-move/move.cpp", "m"}},
                          false);
  const ClassFolder found = delivery.find();
  REQUIRE(ids_of(found) == Ids{"ada-11", "bob-12"});
  for (const HandedIn& handed : found.submissions) {
    CHECK(handed.sources == std::vector<fs::path>{delivery.source / "submission_1"});
    CHECK(handed.handed_in == 9);
    CHECK(any_says(handed.notes, "submission_1 is of a group: Ada, Bob"));
  }
}

TEST_CASE("a class of which one student has handed in steps is a class") {
  for (const char* text : {"bob/", "bob/readme.txt"}) {
    INFO(text);
    const Delivery delivery({{"ada/01-move/move.cpp", "m"}}, false);
    fs::create_directories(delivery.source / "bob");
    if (!std::string_view(text).ends_with('/')) write_file(delivery.source / text, std::string_view("x"));
    CHECK(delivery.is_class());
    const ClassFolder found = delivery.find();
    REQUIRE(ids_of(found) == Ids{"ada", "bob"});
    CHECK_FALSE(delivery.take(found.submissions[1]).needs_human.empty());
  }
  const Delivery pictures({{"ada/01-move/move.cpp", "m"}, {"holiday/a.png", "x"}}, false);
  CHECK_FALSE(pictures.is_class());
}

TEST_CASE("one student's broken archive is no other's problem") {
  const TemporaryFolder made;
  write_archive(made.path() / "a.zip", {{"01-move/move.cpp", "m"}}, "secret");
  const std::string encrypted = read_file(made.path() / "a.zip");
  const Delivery delivery({{"ada.zip", move_zip()},
                           {"bob.zip", move_zip().substr(0, move_zip().size() / 2)},
                           {"carl.rar", "Rar!\x1a\x07"},
                           {"dora.zip", encrypted},
                           {"emil/essay.docx", "x"},
                           {"fritz/nothing.txt", "x"},
                           {"gus.zip", ""},
                           {"hans.zip", archive_bytes("a.zip", {{"01-move/move.cpp", "", "/etc/passwd"}})},
                           {"ines/hw.rar", "Rar!\x1a\x07"},
                           {"readme.txt", "x"}},
                          false);
  fs::create_symlink("/etc", delivery.source / "zoe");
  fs::create_directories(delivery.source / "nobody");
  CHECK(delivery.is_class());
  const ClassFolder found = delivery.find();
  CHECK(ids_of(found) == Ids{"ada", "bob", "carl", "dora", "emil", "fritz", "gus", "hans", "ines", "nobody"});
  const auto why = [&](std::size_t i) {
    const Submission taken = delivery.take(found.submissions.at(i));
    return taken.needs_human.empty() ? std::string() : taken.needs_human[0];
  };
  CHECK(why(0) == "");
  CHECK(why(1).starts_with("bob.zip is cut off or damaged"));
  CHECK(why(2).starts_with("carl.rar is a RAR archive"));
  CHECK(why(3).starts_with("dora.zip contains the encrypted file 01-move/move.cpp"));
  CHECK(why(4) == "emil has none of the steps; it has essay.docx");
  CHECK(why(5) == "fritz has none of the steps; it has nothing.txt");
  CHECK(why(6).starts_with("gus.zip is empty (0 bytes)"));
  CHECK(why(7) == "01-move/move.cpp is a symbolic link, which is not followed");
  CHECK(why(8).starts_with("ines: hw.rar is a RAR archive"));
  CHECK(why(9) == "nobody is empty: nothing was handed in");
  CHECK(any_says(found.ignored, "zoe is a symbolic link, which is not followed"));
  CHECK(any_says(found.ignored, "readme.txt is neither a folder nor an archive"));
}

TEST_CASE("an instructor's pattern names the students") {
  const std::vector<Member> members = {{"all/hw2_ada_11/01-move/move.cpp", "m"},
                                       {"all/hw2_bob_12.zip", move_zip()},
                                       {"all/other/01-move/move.cpp", "m"}};
  for (const bool packed : {false, true}) {
    const Delivery delivery(members, packed);
    const ClassFolder found = delivery.find({.pattern = R"(hw2_([a-z]+)_(\d+)(?:\.zip)?)"});
    CHECK(found.platform == "pattern");
    REQUIRE(ids_of(found) == Ids{"ada-11", "bob-12", "other"});
    CHECK(found.submissions[0].student.name == "ada");
    CHECK(found.submissions[0].student.identifier == "11");
    CHECK(any_says(found.submissions[2].needs_human, "'other' does not match the pattern"));
    CHECK(ids_of(delivery.find({.pattern = "hw2_([a-z]+).*"})) == Ids{"ada", "bob", "other"});
    CHECK(mentions(error_of([&] { delivery.find({.pattern = "("}); }), {"'('", "no regular expression"}));
    CHECK(mentions(error_of([&] { delivery.find({.pattern = "hw"}); }), {"'hw'", "one group"}));
    CHECK(mentions(error_of([&] { delivery.find({.pattern = "(nothing)"}); }),
                   {delivery.source.string(), "has no submission", "does not match"}));
  }
}

TEST_CASE("several paths are a class: submissions, or classes of their own") {
  const TemporaryFolder folder;
  write_archive(folder.path() / "ada.zip", {{"01-move/move.cpp", "m"}});
  write_file(folder.path() / "bob/move.cpp", std::string_view("m"));
  write_file(folder.path() / "broken.zip", std::string_view("PK"));
  write_archive(folder.path() / "B.zip", {{"C_1_assignsubmission_file_/01-move/move.cpp", "m"}});
  const auto find = [&](const std::vector<const char*>& names) {
    std::vector<fs::path> sources;
    for (const char* name : names) sources.push_back(folder.path() / name);
    return find_submissions(three_steps, sources, folder.path() / "unpacked");
  };
  CHECK(ids_of(find({"ada.zip", "bob", "broken.zip", "B.zip"})) == Ids{"ada", "bob", "broken", "c-1"});
  CHECK(ids_of(find({"ada.zip"})) == Ids{"ada"});
  CHECK(mentions(error_of([&] { find({"ada.zip", "nowhere"}); }), {"nowhere", "no such"}));
}

TEST_CASE("the archive of a class can do no harm") {
  const Delivery delivery({{"ada/01-move/move.cpp", "m"},
                           {"../outside.txt", "x"},
                           {"/tmp/atelier-outside.txt", "x"},
                           {"bob/01-move", "", "/etc"},
                           {"bob/move.cpp", "m"},
                           {"carl/" + std::string(300, 'n') + ".txt", "x"},
                           {"carl/02-light-up/light.cpp", "c"}},
                          true);
  const ClassFolder found = delivery.find();
  CHECK(ids_of(found) == Ids{"ada", "bob", "carl"});
  CHECK_FALSE(fs::exists(delivery.folder.path() / "outside.txt"));
  CHECK_FALSE(fs::exists("/tmp/atelier-outside.txt"));
  for (const auto& entry : fs::recursive_directory_iterator(delivery.folder.path() / "unpacked"))
    CHECK_FALSE(entry.is_symlink());
  CHECK(any_says(found.ignored, "../outside.txt leads out"));
  CHECK(any_says(found.submissions[1].needs_human, "01-move is a symbolic link"));
  CHECK(any_says(found.submissions[2].notes, "has a name that this system cannot store"));
}

TEST_CASE("what a class's archive does not give up is said once") {
  const Delivery delivery({{"ada.zip", move_zip()}, {"bob.zip", move_zip()}, {"dora.zip", "", "/etc/passwd"}}, true);
  const ClassFolder found = delivery.find();
  REQUIRE(ids_of(found) == Ids{"ada", "bob", "dora"});
  CHECK(found.submissions[2].needs_human.size() == 1);
  CHECK(delivery.take(found.submissions[2]).needs_human.empty());
}

TEST_CASE("a student's folder cannot pass for several students") {
  const Delivery delivery({{"ada/01-move/move.cpp", "m"},
                           {"mallory/Bob_12_assignsubmission_file_/01-move/move.cpp", "m"},
                           {"mallory/Carl_13_assignsubmission_file_/01-move/move.cpp", "m"},
                           {"mallory/submission_metadata.yml", "submission_1:"}},
                          true);
  CHECK(ids_of(delivery.find()) == Ids{"ada", "mallory"});
}

TEST_CASE("an archive that inflates without end is no class") {
  const TemporaryFolder folder;
  const std::string zeros(std::size_t(100) << 20, '\0');
  write_archive(folder.path() / "bomb.tar.gz", {{"ada/01-move/move.cpp", "m"},
                                                {"bob/1.bin", zeros},
                                                {"bob/2.bin", zeros},
                                                {"bob/3.bin", zeros},
                                                {"bob/01-move/move.cpp", "m"}});
  CHECK_FALSE(is_class(three_steps, {folder.path() / "bomb.tar.gz"}));
  CHECK(mentions(error_of([&] { find_submissions(three_steps, {folder.path() / "bomb.tar.gz"}, folder.path() / "u"); }),
                 {"bomb.tar.gz: inflates to more than 268435456 bytes"}));
}

TEST_CASE("more than a thousand submissions are found") {
  const TemporaryFolder folder;
  constexpr int count = 1500;
  for (int i = 0; i < count; ++i)
    write_file(
        folder.path() / ("class/S" + std::to_string(i) + "_" + std::to_string(i) + "_assignsubmission_file_/move.cpp"),
        std::string_view("m"));
  const ClassFolder found = find_submissions(three_steps, {folder.path() / "class"}, folder.path() / "unpacked");
  CHECK(found.submissions.size() == count);
}

TEST_CASE("a folder without a submission is an error") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "empty");
  CHECK(mentions(error_of([&] { find_submissions(three_steps, {folder.path() / "none"}, folder.path() / "u"); }),
                 {"none", "no such"}));
}

TEST_CASE("names that differ only by case may be one student's") {
  const Delivery delivery({{"Ada/move.cpp", "m"}, {"ada/move.cpp", "m"}, {"bob/move.cpp", "m"}}, false);
  const ClassFolder found = delivery.find();
  CHECK(any_says(found.submissions[0].needs_human, "same student as 'ada'"));
  CHECK(any_says(found.submissions[1].needs_human, "same student as 'Ada'"));
  CHECK(found.submissions[2].needs_human.empty());
}
