// Archives and folders that attack whoever reads them: each is handed in beside an honest submission of step 00, whose
// grade does not change. They are made here, since no repository should hold them.
#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"
#include "hostile_canary.hpp"
#include "hostile_submissions.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

namespace fs = std::filesystem;

namespace {

const std::string archive_step = "00-hello", wanted_member = archive_step + "/hello.glsl";
const std::string outside = "/tmp/atelier-canary";  // what is written there, the canary finds

/// A member of an archive; `kind` as in archive_entry_set_filetype.
struct BadMember {
  std::string name, bytes;
  unsigned kind = AE_IFREG;
  std::string link = {};       ///< where a symbolic link leads
  std::string hard_link = {};  ///< another member's name, or whatever is called that
  std::size_t zeros = 0;       ///< instead of bytes
};

void write_data(archive* out, const BadMember& member) {
  if (member.zeros == 0) {
    archive_write_data(out, member.bytes.data(), member.bytes.size());
    return;
  }
  const std::string block(1 << 20, '\0');
  for (std::size_t left = member.zeros; left > 0; left -= std::min(left, block.size()))
    archive_write_data(out, block.data(), std::min(left, block.size()));
}

/// The format follows from the file's extension.
void pack(const fs::path& file, const std::vector<BadMember>& members) {
  const std::unique_ptr<archive, int (*)(archive*)> out(archive_write_new(), archive_write_free);
  REQUIRE(archive_write_set_format_filter_by_ext(out.get(), file.c_str()) == ARCHIVE_OK);
  REQUIRE(archive_write_open_filename(out.get(), file.c_str()) == ARCHIVE_OK);
  for (const BadMember& member : members) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(), archive_entry_free);
    archive_entry_set_pathname(entry.get(), member.name.c_str());
    archive_entry_set_perm(entry.get(), 0777);
    archive_entry_set_size(entry.get(), la_int64_t(member.zeros ? member.zeros : member.bytes.size()));
    archive_entry_set_filetype(entry.get(), member.kind);
    if (!member.link.empty()) archive_entry_set_symlink(entry.get(), member.link.c_str());
    if (!member.hard_link.empty()) archive_entry_set_hardlink(entry.get(), member.hard_link.c_str());
    if (member.kind == AE_IFCHR) archive_entry_set_rdev(entry.get(), 0x105);  // the device of /dev/zero
    REQUIRE(archive_write_header(out.get(), entry.get()) >= ARCHIVE_WARN);
    if (member.kind == AE_IFREG && member.hard_link.empty()) write_data(out.get(), member);
  }
  REQUIRE(archive_write_close(out.get()) == ARCHIVE_OK);
}

std::string honest_shader() {
  return read_file(folders().solutions() / wanted_member);
}

std::vector<BadMember> many_members(std::size_t count) {
  std::vector<BadMember> members = {{wanted_member, honest_shader()}};
  for (std::size_t i = 0; i < count; ++i) members.push_back({fmt::format("{}/{}", i % 100, i), ""});
  return members;
}

struct HandedInArchive {
  const char* file;  ///< in the class's folder
  double at_most;    ///< share of the points
  std::function<std::vector<BadMember>()> members;
};

std::vector<HandedInArchive> bad_archives() {
  const std::string shader = honest_shader(), mark = "written by an archive\n";
  const std::string secret = outside + "/secret.txt";
  const auto fixed = [](std::vector<BadMember> members) { return [members] { return members; }; };
  return {
      {"slips.zip", 1,
       fixed({{wanted_member, shader},
              {"../../../../../../../../tmp/atelier-canary/written-slips", mark},
              {"00-hello/../../../../../../../tmp/atelier-canary/written-slips-2", mark},
              {"..\\..\\tmp\\atelier-canary\\written-slips-3", mark},
              {"../hello.glsl", mark}})},
      {"absolute.zip", 1,
       fixed(
           {{wanted_member, shader}, {outside + "/written-absolute", mark}, {"//tmp/atelier-canary/written-2", mark}})},
      {"absolute-tar.tar.gz", 1, fixed({{wanted_member, shader}, {outside + "/written-absolute-tar", mark}})},
      {"link-to-secret.zip", 0, fixed({{wanted_member, "", AE_IFLNK, secret}})},
      {"link-to-secret-tar.tar", 0, fixed({{wanted_member, "", AE_IFLNK, secret}})},
      {"link-to-solution.tar", 0,
       fixed({{wanted_member, "", AE_IFLNK, (folders().solutions() / wanted_member).string()}})},
      {"hard-link.tar", 0, fixed({{wanted_member, "", AE_IFREG, "", secret}})},
      {"folder-is-link.tar", 0,
       fixed({{"00-hello", "", AE_IFLNK, outside + "/victims"}, {"00-hello/translation.values", mark}})},
      {"folder-is-solution.tar", 0,
       fixed({{"00-hello", "", AE_IFLNK, (folders().solutions() / archive_step).string()}})},
      {"device.tar", 0, fixed({{wanted_member, "", AE_IFCHR}})},
      {"pipe.tar", 0, fixed({{wanted_member, "", AE_IFIFO}})},
      {"bomb.zip", 0, fixed({{wanted_member, "", AE_IFREG, "", "", std::size_t(300) << 20}})},
      {"bomb-beside.tar.gz", 1,
       fixed({{wanted_member, shader}, {"notes", "", AE_IFREG, "", "", std::size_t(300) << 20}})},
      {"bomb.tar.xz", 0, fixed({{"notes", "", AE_IFREG, "", "", std::size_t(300) << 20}, {wanted_member, shader}})},
      {"many-members.zip", 0, [] { return many_members(100'000); }},
      {"twice.zip", 0, fixed({{wanted_member, shader}, {wanted_member, "#error the other\n"}})},
      {"names.zip", 1,
       fixed({{wanted_member, shader},
              {"<script>alert('atelier-hostile')</script>\x1b[31m\x1b]0;owned\x07", mark, AE_IFLNK, "/etc/passwd"},
              {"../\xe2\x80\xae=1+1", mark},
              {std::string(3000, 'n') + "/..", mark}})},
      {"deep.zip", 1,
       [shader] {
         std::string path;
         for (int i = 0; i < 1000; ++i) path += "d/";
         return std::vector<BadMember>{{wanted_member, shader}, {path + wanted_member, "#error a copy\n"}};
       }},
  };
}

/// Folders that lead elsewhere, or hold what is no file.
struct HandedInFolder {
  const char* name;
  double at_most;
  std::function<void(const fs::path&)> make;
};

std::vector<HandedInFolder> bad_folders(const fs::path& honest) {
  const auto step_in = [](const fs::path& folder) {
    fs::create_directories(folder / archive_step);
    return folder / wanted_member;
  };
  return {
      {"is-a-link", 0, [=](const fs::path& folder) { fs::create_directory_symlink(honest, folder); }},
      {"step-is-a-link", 0,
       [=](const fs::path& folder) {
         fs::create_directories(folder);
         fs::create_directory_symlink(honest / archive_step, folder / archive_step);
       }},
      {"step-is-the-solution", 0,
       [=](const fs::path& folder) {
         fs::create_directories(folder);
         fs::create_directory_symlink(folders().solutions() / archive_step, folder / archive_step);
       }},
      {"file-is-a-link", 0,
       [=](const fs::path& folder) { fs::create_symlink(honest / wanted_member, step_in(folder)); }},
      {"file-is-a-device", 0, [=](const fs::path& folder) { fs::create_symlink("/dev/zero", step_in(folder)); }},
      {"file-is-a-pipe", 0, [=](const fs::path& folder) { REQUIRE(::mkfifo(step_in(folder).c_str(), 0666) == 0); }},
      {"file-is-a-folder", 0, [=](const fs::path& folder) { fs::create_directory(step_in(folder)); }},
      {"file-is-huge", 0,
       [=](const fs::path& folder) {
         const fs::path file = step_in(folder);
         write_file(file, std::string_view("//"));
         fs::resize_file(file, std::uintmax_t(1) << 40);
       }},
      {"links-in-a-circle", 0,
       [=](const fs::path& folder) {
         fs::create_directories(folder);
         fs::create_directory_symlink(folder, folder / "again");
         fs::create_directory_symlink("..", folder / archive_step);
       }},
      {"=1+1<b>hostile\x1b[31m", 1, [=](const fs::path& folder) { write_file(step_in(folder), honest_shader()); }},
      {"<script>alert('atelier-hostile')<", 1,
       [=](const fs::path& folder) { write_file(step_in(folder), honest_shader()); }},
  };
}

/// The share of points in what is left of a submission's results; nothing if there are none.
double share_in(const fs::path& folder) {
  if (!fs::exists(folder / "results.json")) return 0;
  const json results = json::parse(read_file(folder / "results.json"));
  // Step 00 has no points: count the cases that have passed.
  int passed = 0, all = 0;
  for (const json& step : results.at("steps"))
    for (const json& c : step["cases"]) ++all, passed += c["status"] == "passed";
  return all == 0 ? 0 : double(passed) / all;
}

/// The student who hands it in: "archive-bomb-tar-xz".
std::string student_of(const HandedInArchive& row) {
  std::string name = std::string("archive-") + row.file;
  std::replace(name.begin(), name.end(), '.', '-');
  return name;
}

}  // namespace

TEST_CASE("hostile archives and folders reach nothing and leave nothing", "[hostile][hostile-all]") {
  Canary canary;
  const TemporaryFolder work("atelier-steps-test");
  const fs::path students = work.path() / "class", out = work.path() / "out", honest = students / "an-honest-one";
  write_honest_submission(archive_step, honest, honest_mark + " " + canary.honest());
  for (const HandedInArchive& row : bad_archives()) {
    fs::create_directories(students / student_of(row));
    pack(students / student_of(row) / row.file, row.members());
  }
  for (const HandedInFolder& row : bad_folders(honest)) row.make(students / row.name);

  const Finished finished = canary.grade({students.string(), "--out", out.string(), "--step", archive_step});
  INFO(finished.output);
  REQUIRE(!finished.timed_out);
  REQUIRE(finished.exit_status == 0);
  for (const std::string& sentence : canary.found_changed()) FAIL_CHECK(sentence);
  CHECK(share_in(out / "students/an-honest-one") == 1);
  for (const HandedInArchive& row : bad_archives()) {
    INFO(row.file);
    CHECK(share_in(out / "students" / student_of(row)) <= row.at_most);
  }
  for (const HandedInFolder& row : bad_folders(honest)) {
    INFO(row.name);
    CHECK(share_in(out / "students" / row.name) <= row.at_most);
  }
  for (const auto& [file, bytes] : files_with_bytes(out)) {
    INFO(file.string());
    CHECK(bytes.find(canary.secret()) == std::string::npos);
    CHECK(!live_text(file, bytes));
    // A spreadsheet would compute it.
    if (file.extension() == ".csv")
      for (const char* formula : {"\n=1+1", ",=1+1", "\"=1+1"}) CHECK(bytes.find(formula) == std::string::npos);
  }
  CHECK(finished.output.find('\x1b') == std::string::npos);
}
