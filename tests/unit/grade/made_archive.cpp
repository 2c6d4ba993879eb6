#include "made_archive.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <memory>

#include "base/file.hpp"
#include "catch.hpp"

namespace atelier::test {

namespace fs = std::filesystem;

void write_archive(const fs::path& file, const std::vector<Member>& members, const std::string& password) {
  fs::create_directories(file.parent_path());
  const std::unique_ptr<archive, int (*)(archive*)> out(archive_write_new(), archive_write_free);
  REQUIRE(archive_write_set_format_filter_by_ext(out.get(), file.c_str()) == ARCHIVE_OK);
  if (!password.empty()) {
    REQUIRE(archive_write_set_options(out.get(), "zip:encryption=traditional") == ARCHIVE_OK);
    REQUIRE(archive_write_set_passphrase(out.get(), password.c_str()) == ARCHIVE_OK);
  }
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

std::string archive_bytes(const std::string& name, const std::vector<Member>& members) {
  const TemporaryFolder folder;
  write_archive(folder.path() / name, members);
  return read_file(folder.path() / name);
}

ReadMembers read_members(const fs::path& file, const std::set<std::string>& wanted,
                         const grade::ArchiveLimits& limits) {
  ReadMembers read;
  read.contents = grade::read_archive(
      file, [&](const std::string& name) { return wanted.contains(name) ? judge::source_limit : 0; },
      [&](const std::string& name, std::string bytes) { read.files[name] = std::move(bytes); }, limits);
  return read;
}

}  // namespace atelier::test
