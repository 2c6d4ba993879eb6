#include "grade/unzip.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "base/error.hpp"
#include "case/printable.hpp"

namespace atelier::grade {
namespace {

namespace fs = std::filesystem;

using Archive = std::unique_ptr<archive, int (*)(archive*)>;

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw Error(fmt::format("{}: {}", file.string(), what));
}

/// The library's own words are about bytes of the archive, so they may hold a member's name.
std::string words_of(archive* reader) {
  const char* words = archive_error_string(reader);
  return shorten(printable(words ? words : "no reason given"), 200);
}

Archive open_zip(const fs::path& file, const ZipLimits& limits) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) refuse(file, "is no regular file; a submission is a folder or a ZIP of one");
  if (const auto size = fs::file_size(file, error); error || size > limits.archive_bytes)
    refuse(file, fmt::format("is too large; an archive may have {} bytes", limits.archive_bytes));
  Archive reader(archive_read_new(), archive_read_free);
  // The list of members at the end of the file is what counts, as for every unpacker that a student has tried it with.
  if (!reader || archive_read_support_format_zip_seekable(reader.get()) != ARCHIVE_OK)
    refuse(file, "cannot be read: the archive library does not know ZIP");
  if (archive_read_open_filename(reader.get(), file.c_str(), 1 << 16) != ARCHIVE_OK)
    refuse(file, "is no ZIP archive: " + words_of(reader.get()));
  return reader;
}

/// A member's name as wanted, and the folder in front of it.
struct Place {
  std::string name, front;
};

/// Nothing where the member is not wanted.
std::optional<Place> place_of(const std::string& member, const std::set<std::string>& wanted) {
  if (wanted.contains(member)) return Place{member, ""};
  const auto slash = member.find('/');
  if (slash == std::string::npos || !wanted.contains(member.substr(slash + 1))) return std::nullopt;
  return Place{member.substr(slash + 1), member.substr(0, slash)};
}

class ZipReader {
 public:
  ZipReader(const fs::path& file, const ZipLimits& limits)
      : file_(file), limits_(limits), reader_(open_zip(file, limits)), archive_bytes_(fs::file_size(file)) {}

  std::map<std::string, std::string> read(const std::set<std::string>& wanted) {
    std::map<std::string, std::string> found;
    std::optional<std::string> front;
    while (archive_entry* entry = next()) {
      const char* name = archive_entry_pathname(entry);
      const auto place = name ? place_of(name, wanted) : std::nullopt;
      const bool plain =
          archive_entry_filetype(entry) == AE_IFREG && !archive_entry_symlink(entry) && !archive_entry_hardlink(entry);
      if (!place || !plain) continue;
      if (front && *front != place->front)
        refuse(file_, fmt::format("has steps in two folders, '{}' and '{}'; it must be one submission",
                                  printable(*front), printable(place->front)));
      front = place->front;
      if (found.contains(place->name)) refuse(file_, place->name + " is there twice");
      found[place->name] = inflate(entry, place->name);
    }
    return found;
  }

 private:
  archive_entry* next() {
    archive_entry* entry = nullptr;
    const int status = archive_read_next_header(reader_.get(), &entry);
    if (status == ARCHIVE_EOF) return nullptr;
    if (status < ARCHIVE_WARN) refuse(file_, "is no whole ZIP archive: " + words_of(reader_.get()));
    if (++members_ > limits_.members) refuse(file_, fmt::format("has more than {} members", limits_.members));
    return entry;
  }

  std::string inflate(archive_entry* entry, const std::string& name) {
    if (archive_entry_is_encrypted(entry)) refuse(file_, name + " is encrypted; make the archive without a password");
    std::string bytes;
    char block[1 << 14];
    for (;;) {
      const la_ssize_t count = archive_read_data(reader_.get(), block, sizeof block);
      if (count == 0) return bytes;
      if (count < 0) refuse(file_, fmt::format("{} cannot be inflated: {}", name, words_of(reader_.get())));
      bytes.append(block, std::size_t(count));
      total_ += std::size_t(count);
      check_cost(bytes.size(), name);
    }
  }

  void check_cost(std::size_t member_bytes, const std::string& name) const {
    if (member_bytes > limits_.member_bytes)
      refuse(file_, fmt::format("{} is too large; a file may have {} bytes", name, limits_.member_bytes));
    if (total_ > limits_.total_bytes)
      refuse(file_, fmt::format("the steps' files together may have {} bytes", limits_.total_bytes));
    if (double(total_) > limits_.ratio * double(archive_bytes_))
      refuse(file_, fmt::format("{} inflates to more than {:g} times the archive; that is no source code", name,
                                limits_.ratio));
  }

  fs::path file_;
  ZipLimits limits_;
  Archive reader_;
  std::size_t archive_bytes_ = 0, total_ = 0;
  int members_ = 0;
};

}  // namespace

std::map<std::string, std::string> read_zip(const fs::path& file, const std::set<std::string>& wanted,
                                            const ZipLimits& limits) {
  return ZipReader(file, limits).read(wanted);
}

}  // namespace atelier::grade
