#include "grade/unzip.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <locale.h>

#include <memory>
#include <optional>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/printable.hpp"

namespace atelier::grade {
namespace {

namespace fs = std::filesystem;

using Archive = std::unique_ptr<archive, int (*)(archive*)>;

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw Error(fmt::format("{}: {}", file.string(), what));
}

/// The library's error message, made printable: it may contain a member's name.
std::string words_of(archive* reader) {
  const char* words = archive_error_string(reader);
  return shorten(printable(words ? words : "no reason given"), 200);
}

/// Why a file is not a valid ZIP, from its first bytes, since the library's message does not distinguish these cases.
std::string why_not_zip(const fs::path& file) {
  struct Kind {
    std::string_view magic;
    const char* words;
  };
  constexpr std::string_view zip("PK\x03\x04", 4);
  static constexpr Kind kinds[] = {{"\x1f\x8b", "a gzip archive"},
                                   {"7z\xbc\xaf", "a 7z archive"},
                                   {"Rar!", "a RAR archive"},
                                   {"BZh", "a bzip2 archive"}};
  const std::string bytes = read_file(file);
  if (bytes.starts_with(zip))
    return "is cut off or damaged: it begins as a ZIP, but the list of members at its end is missing";
  if (bytes.starts_with("PK\x05\x06")) return "is an empty archive";
  for (const Kind& kind : kinds)
    if (bytes.starts_with(kind.magic)) return std::string("is ") + kind.words + ", not a ZIP";
  return "is not a ZIP archive";
}

Archive open_zip(const fs::path& file, const ZipLimits& limits) {
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    refuse(file, "is not a regular file; a submission is a folder or a ZIP of one");
  const auto size = fs::file_size(file, error);
  if (error || size > limits.archive_bytes)
    refuse(file, fmt::format("is too large; an archive may have at most {} bytes", limits.archive_bytes));
  if (size == 0) refuse(file, "is empty (0 bytes); a submission is a folder or a ZIP of one");
  Archive reader(archive_read_new(), archive_read_free);
  // Read the list of members at the end of the file, as other unpackers do.
  if (!reader || archive_read_support_format_zip_seekable(reader.get()) != ARCHIVE_OK)
    refuse(file, "cannot be read: the archive library does not support ZIP");
  if (archive_read_open_filename(reader.get(), file.c_str(), 1 << 16) != ARCHIVE_OK) refuse(file, why_not_zip(file));
  return reader;
}

/// A wanted member's name, split into the optional folder in front (`prefix`) and the wanted name.
struct Place {
  std::string name, prefix;
};

/// Nothing if the member is not wanted.
std::optional<Place> place_of(const std::string& member, const std::set<std::string>& wanted) {
  if (wanted.contains(member)) return Place{member, ""};  // no prefix
  const auto slash = member.find('/');
  if (slash == std::string::npos || !wanted.contains(member.substr(slash + 1))) return std::nullopt;
  return Place{member.substr(slash + 1), member.substr(0, slash)};
}

/// Whether a path leads out of the folder that it would be unpacked in.
bool leads_out(const std::string& path) {
  if (path.starts_with('/')) return true;
  for (const fs::path& part : fs::path(path))
    if (part == "..") return true;
  return false;
}

/// Why a member is not a regular file; empty if it is one.
std::string why_not_regular(archive_entry* entry) {
  if (archive_entry_filetype(entry) == AE_IFLNK || archive_entry_symlink(entry)) return judge::is_link;
  if (archive_entry_hardlink(entry)) return "is a hard link, which is not followed";
  if (archive_entry_filetype(entry) != AE_IFREG) return "is not a regular file";
  return {};
}

/// Sets this thread's locale to UTF-8 until the end of the scope. In the locale "C", in which this program runs, the
/// library returns no name that the archive marks as UTF-8.
class Utf8Locale {
 public:
  Utf8Locale() : utf8_(::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (utf8_) before_ = ::uselocale(utf8_);
  }
  ~Utf8Locale() {
    if (!utf8_) return;
    ::uselocale(before_);
    ::freelocale(utf8_);
  }
  Utf8Locale(const Utf8Locale&) = delete;
  Utf8Locale& operator=(const Utf8Locale&) = delete;

 private:
  locale_t utf8_, before_ = nullptr;
};

/// A member's path without the leading "./" that some programs write.
std::string name_of(archive_entry* entry) {
  const char* path = archive_entry_pathname(entry);
  std::string name = path ? path : "(a member without a readable name)";
  while (name.starts_with("./")) name.erase(0, 2);
  return name;
}

class ZipReader {
 public:
  ZipReader(const fs::path& file, const ZipLimits& limits)
      : file_(file), limits_(limits), reader_(open_zip(file, limits)), archive_bytes_(fs::file_size(file)) {}

  ZipContents read(const std::set<std::string>& wanted) {
    while (archive_entry* entry = next()) {
      const std::string name = name_of(entry);
      contents_.names.push_back(name);
      const std::string special = why_not_regular(entry);
      const auto place = place_of(name, wanted);
      if (leads_out(name))
        skip(name, "leads out of the archive's folder");
      else if (place)
        take(entry, *place, special);
      else if (!special.empty() && archive_entry_filetype(entry) != AE_IFDIR)
        skip(name, special);
    }
    return std::move(contents_);
  }

 private:
  void skip(const std::string& name, const std::string& why) {
    contents_.skipped.push_back(shorten(printable(name), 100) + " " + why);
  }

  void take(archive_entry* entry, const Place& place, const std::string& special) {
    if (prefix_ && *prefix_ != place.prefix)
      refuse(file_, fmt::format("has steps in two folders, '{}' and '{}'; it must be one submission",
                                printable(*prefix_), printable(place.prefix)));
    prefix_ = place.prefix;
    if (contents_.files.contains(place.name) || contents_.unusable.contains(place.name))
      refuse(file_, "contains " + place.name + " twice");
    if (!special.empty())
      contents_.unusable[place.name] = special;
    else if (auto bytes = inflate(entry, place.name))
      contents_.files[place.name] = std::move(*bytes);
    else
      contents_.unusable[place.name] = judge::is_too_large(limits_.member_bytes);
  }

  archive_entry* next() {
    archive_entry* entry = nullptr;
    const int status = archive_read_next_header(reader_.get(), &entry);
    if (status == ARCHIVE_EOF) return nullptr;
    if (status < ARCHIVE_WARN) refuse(file_, "is not a complete ZIP archive: " + words_of(reader_.get()));
    if (++members_ > limits_.members) refuse(file_, fmt::format("has more than {} members", limits_.members));
    return entry;
  }

  /// Nothing if the member is too large; the rest of it is not read.
  std::optional<std::string> inflate(archive_entry* entry, const std::string& name) {
    if (archive_entry_is_encrypted(entry))
      refuse(file_, "contains the encrypted file " + name + "; make the archive without a password");
    std::string bytes;
    char block[1 << 14];
    for (;;) {
      const la_ssize_t count = archive_read_data(reader_.get(), block, sizeof block);
      if (count == 0) return bytes;
      if (count < 0) refuse(file_, fmt::format("{} cannot be inflated: {}", name, words_of(reader_.get())));
      bytes.append(block, std::size_t(count));
      total_ += std::size_t(count);
      check_limits(name);
      if (bytes.size() > limits_.member_bytes) return std::nullopt;
    }
  }

  void check_limits(const std::string& name) const {
    if (total_ > limits_.total_bytes)
      refuse(file_, fmt::format("the steps' files together may have at most {} bytes", limits_.total_bytes));
    if (double(total_) > limits_.ratio * double(archive_bytes_))
      refuse(file_, fmt::format("{} inflates to more than {:g} times the archive's size; source code never does", name,
                                limits_.ratio));
  }

  Utf8Locale utf8_;  // before reader_, which reads the locale when it opens the file
  fs::path file_;
  ZipLimits limits_;
  Archive reader_;
  std::size_t archive_bytes_ = 0, total_ = 0;
  int members_ = 0;
  std::optional<std::string> prefix_;  ///< the folder in front of the steps' folders, once a wanted member was found
  ZipContents contents_;
};

}  // namespace

ZipContents read_zip(const fs::path& file, const std::set<std::string>& wanted, const ZipLimits& limits) {
  return ZipReader(file, limits).read(wanted);
}

}  // namespace atelier::grade
