#include "grade/submission.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <unistd.h>

#include <memory>

#include "base/file.hpp"
#include "catch.hpp"
#include "grade/archive.hpp"
#include "grade/varied_cases.hpp"

using namespace atelier;
using namespace atelier::grade;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

namespace fs = std::filesystem;

struct Member {
  std::string name, bytes;
  std::string link = {};  ///< makes it a symbolic link to this
};

/// Writes an archive with libarchive, names as they are: also those that no decent program would write. The format
/// follows from the file's extension.
void write_archive(const fs::path& file, const std::vector<Member>& members) {
  const std::unique_ptr<archive, int (*)(archive*)> out(archive_write_new(), archive_write_free);
  REQUIRE(archive_write_set_format_filter_by_ext(out.get(), file.c_str()) == ARCHIVE_OK);
  REQUIRE(archive_write_open_filename(out.get(), file.c_str()) == ARCHIVE_OK);
  for (const Member& member : members) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(), archive_entry_free);
    archive_entry_set_pathname(entry.get(), member.name.c_str());
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_size(entry.get(), la_int64_t(member.bytes.size()));
    archive_entry_set_filetype(entry.get(), member.link.empty() ? AE_IFREG : AE_IFLNK);
    if (!member.link.empty()) archive_entry_set_symlink(entry.get(), member.link.c_str());
    REQUIRE(archive_write_header(out.get(), entry.get()) >= ARCHIVE_WARN);
    if (member.link.empty()) archive_write_data(out.get(), member.bytes.data(), member.bytes.size());
  }
  REQUIRE(archive_write_close(out.get()) == ARCHIVE_OK);
}

void write_zip(const fs::path& file, const std::vector<Member>& members) {
  write_archive(file, members);
}

const std::set<std::string> wanted = {"01-move/move.cpp", "02-light/light.glsl"};
const judge::StepFlags flags{.files = {{"01-move", {"move.cpp"}}, {"02-light", {"light.cpp", "light.glsl"}}}};

}  // namespace

TEST_CASE("only the wanted members of a ZIP are read") {
  const TemporaryFolder folder;
  const fs::path zip = folder.path() / "a.zip";
  using Found = std::map<std::string, std::string>;
  struct Row {
    const char* name;
    std::vector<Member> members;
    Found found;
  };
  const Row rows[] = {
      {"plain",
       {{"01-move/move.cpp", "int a;"}, {"02-light/light.glsl", "b"}},
       {{"01-move/move.cpp", "int a;"}, {"02-light/light.glsl", "b"}}},
      {"one folder in front", {{"ada/01-move/move.cpp", "a"}}, {{"01-move/move.cpp", "a"}}},
      {"a dot and a folder in front", {{"./ada/01-move/move.cpp", "a"}}, {{"01-move/move.cpp", "a"}}},
      {"others are left alone",
       {{"01-move/CMakeLists.txt", "x"}, {"README", "x"}, {"01-move/move.cpp", "a"}},
       {{"01-move/move.cpp", "a"}}},
      {"two folders in front", {{"a/b/01-move/move.cpp", "a"}}, {{"01-move/move.cpp", "a"}}},
      {"a copy deeper in it",
       {{"a/old/01-move/move.cpp", "b"}, {"a/01-move/move.cpp", "a"}},
       {{"01-move/move.cpp", "a"}}},
      {"what a Mac adds",
       {{"__MACOSX/a/01-move/move.cpp", "b"},
        {"__MACOSX/01-move/._move.cpp", "c"},
        {"a/__MACOSX/01-move/move.cpp", "b"},
        {".git/01-move/move.cpp", "b"},
        {"a/b/01-move/move.cpp", "a"}},
       {{"01-move/move.cpp", "a"}}},
      {"climbing out", {{"../../01-move/move.cpp", "a"}, {"/etc/passwd", "a"}, {"x/../01-move/move.cpp", "a"}}, {}},
      {"a link", {{"01-move/move.cpp", "", "/etc/passwd"}}, {}},
      {"an empty file", {{"01-move/move.cpp", ""}}, {{"01-move/move.cpp", ""}}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    write_zip(zip, row.members);
    CHECK(read_archive(zip, wanted).files == row.found);
  }
}

TEST_CASE("a ZIP whose names are UTF-8, and say so, is read in every locale") {
  const TemporaryFolder folder;
  const fs::path zip = folder.path() / "a.zip";
  write_zip(zip, {{"Müller/01-move/move.cpp", "int a;"}, {"Müller/../ü", "x"}});
  // Bit 11 of the flags: at byte 6 of a member's header and at byte 8 of its entry in the list (APPNOTE.TXT 4.4.4).
  std::string bytes = read_file(zip);
  for (const auto& [mark, place] : {std::pair{"PK\3\4", 7}, std::pair{"PK\1\2", 9}})
    for (std::size_t at = bytes.find(mark); at != std::string::npos; at = bytes.find(mark, at + 1))
      bytes[at + std::size_t(place)] |= 8;
  write_file(zip, bytes);
  const ArchiveContents contents = read_archive(zip, wanted);
  CHECK(contents.files == std::map<std::string, std::string>{{"01-move/move.cpp", "int a;"}});
  CHECK(contents.skipped == std::vector<std::string>{"Müller/../ü leads out of the archive's folder"});
}

TEST_CASE("a submission's name is a valid folder name") {
  const TemporaryFolder folder;
  for (const char* file : {"...zip", "..zip", ".zip"}) {
    INFO(file);
    write_zip(folder.path() / file, {{"01-move/move.cpp", "int a;"}});
    const std::string name = take_submission(flags, folder.path() / file, folder.path() / "copy").name;
    CHECK(name != "");
    CHECK(name != ".");
    CHECK(name != "..");
  }
}

TEST_CASE("skipped members of a ZIP are reported") {
  const TemporaryFolder folder;
  const fs::path zip = folder.path() / "a.zip";
  struct Row {
    const char* name;
    Member member;
    judge::UnusableFiles unusable;
    std::vector<std::string> skipped;
  };
  const std::string large(judge::source_limit + 1, 'x');
  const Row rows[] = {
      {"a wanted link",
       {"01-move/move.cpp", "", "/etc/passwd"},
       {{"01-move/move.cpp", "is a symbolic link, which is not followed"}},
       {}},
      {"too large",
       {"01-move/move.cpp", large},
       {{"01-move/move.cpp", "is larger than the limit of 1000000 bytes"}},
       {}},
      {"climbing", {"../01-move/move.cpp", "a"}, {}, {"../01-move/move.cpp leads out of the archive's folder"}},
      {"climbing inside", {"x/../../y", "a"}, {}, {"x/../../y leads out of the archive's folder"}},
      {"absolute", {"/01-move/move.cpp", "a"}, {}, {"/01-move/move.cpp leads out of the archive's folder"}},
      {"another link", {"notes", "", "/etc"}, {}, {"notes is a symbolic link, which is not followed"}},
      {"hostile name", {"../\x1b[2J", "a"}, {}, {"../\xEF\xBF\xBD[2J leads out of the archive's folder"}},
      {"another file", {"README", "x"}, {}, {}},
      {"dots in a name", {"..notes", "x"}, {}, {}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    write_zip(zip, {row.member, {"02-light/light.glsl", "b"}});
    const ArchiveContents contents = read_archive(zip, wanted, {.ratio = 1e6});
    CHECK(contents.unusable == row.unusable);
    CHECK(contents.skipped == row.skipped);
    CHECK(contents.files == std::map<std::string, std::string>{{"02-light/light.glsl", "b"}});
  }
}

TEST_CASE("archives that are too large or invalid are refused") {
  const TemporaryFolder folder;
  const fs::path zip = folder.path() / "a.zip";
  const std::string text(100'000, 'x');  // deflates to a thousandth
  struct Row {
    const char* name;
    std::vector<Member> members;
    ArchiveLimits limits;
    const char* why;
  };
  const Row rows[] = {
      {"twice", {{"a/01-move/move.cpp", "a"}, {"a/01-move/move.cpp", "b"}}, {}, "twice"},
      {"two submissions", {{"a/01-move/move.cpp", "a"}, {"b/02-light/light.glsl", "b"}}, {}, "two folders"},
      {"large together",
       {{"01-move/move.cpp", text}, {"02-light/light.glsl", text}},
       {.total_bytes = 150'000, .ratio = 1e6},
       "together"},
      {"a bomb", {{"01-move/move.cpp", text}}, {.ratio = 100}, "inflates"},
      {"many members", {{"a", ""}, {"b", ""}, {"c", ""}}, {.members = 2}, "more than 2 members"},
      {"a large archive", {{"01-move/move.cpp", "a"}}, {.archive_bytes = 10}, "too large"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    write_zip(zip, row.members);
    CHECK(mentions(error_of([&] { read_archive(zip, wanted, row.limits); }), {"a.zip", row.why}));
  }
}

TEST_CASE("archives of all formats are read, within the same limits") {
  const TemporaryFolder folder;
  for (const char* name : {"a.zip", "a.tar", "a.tar.gz", "a.tar.xz", "a.7z"}) {
    INFO(name);
    const fs::path file = folder.path() / name;
    write_archive(file, {{"ada/notes.txt", std::string(100'000, 'x')},
                         {"ada/01-move/move.cpp", "int a;"},
                         {"ada/02-light/light.glsl", "", "/etc/passwd"},
                         {"../out", "x"}});
    const ArchiveContents contents = read_archive(file, wanted);
    CHECK(contents.files == std::map<std::string, std::string>{{"01-move/move.cpp", "int a;"}});
    CHECK(contents.unusable.contains("02-light/light.glsl"));
    CHECK(mentions(contents.skipped.at(0), {"../out leads out"}));
    // Cut off: an error, never a part.
    const std::string whole = read_file(file);
    write_file(file, std::string_view(whole).substr(0, whole.size() / 2));
    CHECK(mentions(error_of([&] { read_archive(file, wanted); }), {name}));

    write_archive(file, {{"01-move/move.cpp", std::string(2'000'000, 'a')}});
    CHECK(read_archive(file, wanted, {.ratio = 1e6}).unusable.contains("01-move/move.cpp"));
    if (std::string(name) == "a.zip") continue;  // what nobody wants is not inflated there
    write_archive(file, {{"huge.bin", std::string(2'000'000, '\0')}, {"01-move/move.cpp", "int a;"}});
    CHECK(read_archive(file, wanted, {.ratio = 1e6}).files.size() == 1);
    CHECK(mentions(error_of([&] { read_archive(file, wanted, {.skipped_bytes = 1'000'000}); }), {"inflates to more"}));
  }
}

TEST_CASE("files that are not a complete archive are refused") {
  const TemporaryFolder folder;
  const fs::path zip = folder.path() / "a.zip";
  write_zip(zip, {{"01-move/move.cpp", std::string(5000, 'a') + std::string(5000, 'b')}});
  const std::string whole = read_file(zip);
  struct Row {
    std::string bytes;
    const char* says;
  };
  const Row rows[] = {{"", "is empty (0 bytes)"},
                      {"P", "is no archive; a submission is a folder, or a ZIP, tar, tar.gz"},
                      {"PK nothing", "is no archive"},
                      {"Rar! and more", "is a RAR archive; a submission is"},
                      {"PK\5\6" + std::string(18, '\0'), "is an empty archive"},
                      {"\x1f\x8b\x08 gzip", "a.zip: is "},
                      {whole.substr(0, whole.size() / 2), "is cut off or damaged"},
                      {whole.substr(0, whole.size() - 1), "a.zip: is "}};
  for (const Row& row : rows) {
    INFO(row.bytes.size());
    write_file(zip, std::string_view(row.bytes));
    CHECK(mentions(error_of([&] { read_archive(zip, wanted); }), {"a.zip", row.says}));
  }
  // Any single byte changed: an error or the right bytes, never wrong ones (each member has a checksum) and no crash.
  const std::map<std::string, std::string> right = {
      {"01-move/move.cpp", std::string(5000, 'a') + std::string(5000, 'b')}};
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string broken = whole;
    broken[i] = char(broken[i] ^ 0x55);
    write_file(zip, std::string_view(broken));
    try {
      const auto found = read_archive(zip, wanted).files;
      CHECK((found.empty() || found == right));
    } catch (const Error&) {
    }
  }
  CHECK(mentions(error_of([&] { read_archive(folder.path() / "none.zip", wanted); }), {"none.zip"}));
  CHECK(mentions(error_of([&] { read_archive(folder.path(), wanted); }), {"regular file"}));
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
  write_zip(folder.path() / "ada.zip", members);
  const Submission taken = take_submission(flags, folder.path() / "ada.zip", folder.path() / "copy");
  REQUIRE(taken.notes.size() == max_notes);
  CHECK(taken.notes.back() == "81 more");
}

TEST_CASE("an archive gives the same submission as its folder") {
  const TemporaryFolder folder;
  write_zip(folder.path() / "ada.zip", {{"ada/01-move/move.cpp", "int a;"}, {"ada/notes.txt", "x"}});
  const Submission taken = take_submission(flags, folder.path() / "ada.zip", folder.path() / "copy");
  CHECK(taken.name == "ada");
  CHECK(taken.present == std::set<std::string>{"01-move"});
  CHECK(read_file(taken.folder / "01-move/move.cpp") == "int a;");
  CHECK(taken.source.empty());
}

TEST_CASE("missing files of a step in an archive are reported with the reason") {
  const TemporaryFolder folder;
  write_zip(folder.path() / "ada.zip", {{"02-light/light.cpp", "", "/etc/passwd"}});
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
  write_zip(folder.path() / "other.zip", {{"README", "x"}});
  const auto take = [&](const char* name) {
    return error_of([&] { take_submission(flags, folder.path() / name, folder.path() / "copy"); });
  };
  CHECK(mentions(take("empty"), {"empty", "none of the steps", "01-move"}));
  CHECK(mentions(take("other.zip"), {"other.zip", "none of the steps"}));
  CHECK(mentions(take("nowhere"), {"nowhere", "no such"}));

  write_file(folder.path() / "deep/a/b/01-move/move.cpp", std::string_view("x"));
  CHECK(mentions(take("deep/a/b/01-move"), {"folder of one step", (folder.path() / "deep/a/b").string()}));
  write_file(folder.path() / "stray/src/light.glsl", std::string_view("x"));
  CHECK(mentions(take("stray"), {"src/light.glsl belongs in 02-light/"}));
  fs::create_directories(folder.path() / "linked");
  fs::create_directory_symlink(folder.path() / "deep/a/b/01-move", folder.path() / "linked/01-move");
  CHECK(mentions(take("linked"), {"skipped: 01-move is a symbolic link"}));

  write_zip(folder.path() / "hollow.zip", {{"a/01-move/CMakeLists.txt", "x"}});
  CHECK(mentions(take("hollow.zip"), {"but none of their files"}));
  write_zip(folder.path() / "climbs.zip", {{"../01-move/move.cpp", "x"}});
  CHECK(mentions(take("climbs.zip"), {"skipped: ../01-move/move.cpp leads out"}));
}
