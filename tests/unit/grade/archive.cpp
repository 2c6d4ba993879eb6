#include "grade/intake/archive.hpp"

#include "base/file.hpp"
#include "catch.hpp"
#include "made_archive.hpp"

using namespace atelier;
using namespace atelier::grade;
using atelier::test::error_of;
using atelier::test::Member;
using atelier::test::mentions;
using atelier::test::read_members;
using atelier::test::write_archive;

namespace {

namespace fs = std::filesystem;

const std::set<std::string> wanted = {"01-move/move.cpp", "02-light/light.glsl"};

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
      {"a dot in front", {{"./01-move/move.cpp", "a"}}, {{"01-move/move.cpp", "a"}}},
      {"others are left alone",
       {{"01-move/CMakeLists.txt", "x"}, {"README", "x"}, {"01-move/move.cpp", "a"}},
       {{"01-move/move.cpp", "a"}}},
      {"what tools add",
       {{"__MACOSX/01-move/move.cpp", "b"}, {".git/01-move/move.cpp", "b"}, {"01-move/move.cpp", "a"}},
       {{"01-move/move.cpp", "a"}}},
      {"climbing out", {{"../../01-move/move.cpp", "a"}, {"/etc/passwd", "a"}, {"x/../01-move/move.cpp", "a"}}, {}},
      {"a link", {{"01-move/move.cpp", "", "/etc/passwd"}}, {}},
      {"an empty file", {{"01-move/move.cpp", ""}}, {{"01-move/move.cpp", ""}}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    write_archive(zip, row.members);
    CHECK(read_members(zip, wanted).files == row.found);
  }
}

TEST_CASE("a ZIP whose names are UTF-8, and say so, is read in every locale") {
  const TemporaryFolder folder;
  const fs::path zip = folder.path() / "a.zip";
  write_archive(zip, {{"Müller/move.cpp", "int a;"}, {"Müller/../ü", "x"}});
  // Bit 11 of the flags: at byte 6 of a member's header and at byte 8 of its entry in the list (APPNOTE.TXT 4.4.4).
  std::string bytes = read_file(zip);
  for (const auto& [mark, place] : {std::pair{"PK\3\4", 7}, std::pair{"PK\1\2", 9}})
    for (std::size_t at = bytes.find(mark); at != std::string::npos; at = bytes.find(mark, at + 1))
      bytes[at + std::size_t(place)] |= 8;
  write_file(zip, bytes);
  const auto read = read_members(zip, {"Müller/move.cpp"});
  CHECK(read.files == std::map<std::string, std::string>{{"Müller/move.cpp", "int a;"}});
  CHECK(read.contents.skipped == std::vector<std::string>{"Müller/../ü leads out of the archive's folder"});
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
    write_archive(zip, {row.member, {"02-light/light.glsl", "b"}});
    const auto read = read_members(zip, wanted, {.ratio = 1e6});
    CHECK(read.contents.unusable == row.unusable);
    CHECK(read.contents.skipped == row.skipped);
    CHECK(read.files == std::map<std::string, std::string>{{"02-light/light.glsl", "b"}});
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
      {"twice", {{"01-move/move.cpp", "a"}, {"01-move/move.cpp", "b"}}, {}, "twice"},
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
    write_archive(zip, row.members);
    CHECK(mentions(error_of([&] { read_members(zip, wanted, row.limits); }), {"a.zip", row.why}));
  }
}

TEST_CASE("archives of all formats are read, within the same limits") {
  const TemporaryFolder folder;
  for (const char* name : {"a.zip", "a.tar", "a.tar.gz", "a.tar.xz", "a.7z"}) {
    INFO(name);
    const fs::path file = folder.path() / name;
    write_archive(file, {{"ada/notes.txt", std::string(100'000, 'x')},
                         {"01-move/move.cpp", "int a;"},
                         {"02-light/light.glsl", "", "/etc/passwd"},
                         {"../out", "x"}});
    const auto [files, contents] = read_members(file, wanted);
    CHECK(files == std::map<std::string, std::string>{{"01-move/move.cpp", "int a;"}});
    CHECK(contents.unusable.contains("02-light/light.glsl"));
    CHECK(mentions(contents.skipped.at(0), {"../out leads out"}));
    // Cut off: an error, never a part.
    const std::string whole = read_file(file);
    write_file(file, std::string_view(whole).substr(0, whole.size() / 2));
    CHECK(mentions(error_of([&] { read_members(file, wanted); }), {name}));

    write_archive(file, {{"01-move/move.cpp", std::string(2'000'000, 'a')}});
    CHECK(read_members(file, wanted, {.ratio = 1e6}).contents.unusable.contains("01-move/move.cpp"));
    if (std::string(name) == "a.zip") continue;  // what nobody wants is not inflated there
    write_archive(file, {{"huge.bin", std::string(2'000'000, '\0')}, {"01-move/move.cpp", "int a;"}});
    CHECK(read_members(file, wanted, {.ratio = 1e6}).files.size() == 1);
    CHECK(mentions(error_of([&] { read_members(file, wanted, {.skipped_bytes = 1'000'000}); }), {"inflates to more"}));
  }
}

TEST_CASE("files that are not a complete archive are refused") {
  const TemporaryFolder folder;
  const fs::path zip = folder.path() / "a.zip";
  write_archive(zip, {{"01-move/move.cpp", std::string(5000, 'a') + std::string(5000, 'b')}});
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
    CHECK(mentions(error_of([&] { read_members(zip, wanted); }), {"a.zip", row.says}));
  }
  // Any single byte changed: an error or the right bytes, never wrong ones (each member has a checksum) and no crash.
  const std::map<std::string, std::string> right = {
      {"01-move/move.cpp", std::string(5000, 'a') + std::string(5000, 'b')}};
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string broken = whole;
    broken[i] = char(broken[i] ^ 0x55);
    write_file(zip, std::string_view(broken));
    try {
      const auto found = read_members(zip, wanted).files;
      CHECK((found.empty() || found == right));
    } catch (const Error&) {
    }
  }
  CHECK(mentions(error_of([&] { read_members(folder.path() / "none.zip", wanted); }), {"none.zip"}));
  CHECK(mentions(error_of([&] { read_members(folder.path(), wanted); }), {"regular file"}));
}
