#include "grade/intake/archive.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <locale.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <memory>
#include <optional>
#include <set>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "grade/intake/step_places.hpp"

namespace atelier::grade {
namespace {

namespace fs = std::filesystem;

using Archive = std::unique_ptr<archive, int (*)(archive*)>;

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw Error(fmt::format("{}: {}", name, what));
}

/// The library's error message, made printable: it may contain a member's name.
std::string words_of(archive* reader) {
  const char* words = archive_error_string(reader);
  return shorten(printable(words ? words : "no reason given"), 200);
}

/// What the first bytes of a file say.
enum class ArchiveKind { zip, empty_zip, tar, seven_zip, other };

struct Looks {
  ArchiveKind kind = ArchiveKind::other;
  const char* words = "";  ///< "a RAR archive"; empty if unknown
};

Looks looks_of(std::string_view bytes) {
  const auto begins = [&](std::string_view magic) { return bytes.starts_with(magic); };
  if (begins(std::string_view("PK\x03\x04", 4))) return {ArchiveKind::zip, "a ZIP"};
  if (begins("PK\x05\x06")) return {ArchiveKind::empty_zip, "a ZIP"};
  if (begins("\x1f\x8b") || begins(std::string_view("\3757zXZ\0", 6)) ||
      (bytes.size() > 262 && bytes.compare(257, 5, "ustar") == 0))
    return {ArchiveKind::tar, "a tar archive"};
  if (begins("7z\xbc\xaf\x27\x1c")) return {ArchiveKind::seven_zip, "a 7z archive"};
  if (begins("Rar!")) return {ArchiveKind::other, "a RAR archive"};
  if (begins("BZh")) return {ArchiveKind::other, "a bzip2 archive"};
  return {};
}

bool support(archive* reader, ArchiveKind kind) {
  switch (kind) {
    case ArchiveKind::tar:
      return archive_read_support_format_tar(reader) == ARCHIVE_OK &&
             archive_read_support_filter_gzip(reader) == ARCHIVE_OK &&
             archive_read_support_filter_xz(reader) == ARCHIVE_OK;
    case ArchiveKind::seven_zip:
      return archive_read_support_format_7zip(reader) == ARCHIVE_OK;
    default:  // the list of members at the end of the file, as other unpackers do
      return archive_read_support_format_zip_seekable(reader) == ARCHIVE_OK;
  }
}

constexpr const char* what_is_read = "a submission is a folder, or a ZIP, tar, tar.gz, tar.xz or 7z of one";

/// An archive on the disk or in memory.
struct Opened {
  std::string name;        ///< in messages
  fs::path file;           ///< empty: in memory
  std::string_view bytes;  ///< all of them, or of a file the first
  std::uintmax_t size = 0;
};

constexpr std::size_t first_bytes = 512;  ///< tell the kind of an archive

/// Fills `first`, which must outlive the result.
Opened open_file(const fs::path& file, std::string& first) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) refuse(file.string(), fmt::format("is not a regular file; {}", what_is_read));
  const auto size = fs::file_size(file, error);
  first.resize(first_bytes);
  std::ifstream in(file, std::ios::binary);
  if (error || !in) refuse(file.string(), "cannot be read");
  in.read(first.data(), std::streamsize(first.size()));
  first.resize(std::size_t(in.gcount()));
  return {.name = file.string(), .file = file, .bytes = first, .size = size};
}

Archive open_archive(const Opened& opened, const ArchiveLimits& limits) {
  if (opened.size > limits.archive_bytes)
    refuse(opened.name, fmt::format("is too large; an archive may have at most {} bytes", limits.archive_bytes));
  if (opened.size == 0) refuse(opened.name, fmt::format("is empty (0 bytes); {}", what_is_read));
  const Looks looks = looks_of(opened.bytes);
  if (looks.kind == ArchiveKind::empty_zip) refuse(opened.name, "is an empty archive");
  if (looks.kind == ArchiveKind::other)
    refuse(opened.name, *looks.words ? fmt::format("is {}; {}", looks.words, what_is_read)
                                     : fmt::format("is no archive; {}", what_is_read));
  Archive reader(archive_read_new(), archive_read_free);
  if (!reader || !support(reader.get(), looks.kind))
    refuse(opened.name, fmt::format("cannot be read: the archive library does not support {}", looks.words));
  constexpr std::size_t block = 1 << 16;
  const int status = opened.file.empty()
                         ? archive_read_open_memory(reader.get(), opened.bytes.data(), opened.bytes.size())
                         : archive_read_open_filename(reader.get(), opened.file.c_str(), block);
  if (status != ARCHIVE_OK)
    refuse(opened.name, looks.kind == ArchiveKind::zip
                            ? "is cut off or damaged: it begins as a ZIP, but the list of members at its end is missing"
                            : fmt::format("is cut off or damaged: it begins as {}", looks.words));
  return reader;
}

bool in_folder_of_tools(const std::string& path) {
  return std::ranges::any_of(fs::path(path).parent_path(),
                             [](const fs::path& part) { return is_folder_of_tools(part.string()); });
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

class ArchiveReader {
 public:
  ArchiveReader(const Opened& opened, const WantedBytes& wanted, const TakeMember& take, const ArchiveLimits& limits)
      : opened_(opened), wanted_(wanted), take_(take), limits_(limits), reader_(open_archive(opened, limits)) {}

  ArchiveContents read() {
    while (archive_entry* entry = next()) {
      const std::string name = name_of(entry);
      const std::string special = why_not_regular(entry);
      if (leads_out(name)) {
        skip(name, "leads out of the archive's folder");
        continue;
      }
      contents_.names.push_back(name);
      const std::size_t most = in_folder_of_tools(name) ? 0 : wanted_(name);
      if (most > 0 && archive_entry_filetype(entry) != AE_IFDIR)
        take(entry, name, special, most);
      else if (!special.empty() && archive_entry_filetype(entry) != AE_IFDIR)
        skip(name, special);
    }
    contents_.inflated = total_ + skipped_;
    return std::move(contents_);
  }

 private:
  void skip(const std::string& name, const std::string& why) {
    contents_.skipped.push_back(shorten(printable(name), 100) + " " + why);
  }

  void take(archive_entry* entry, const std::string& name, const std::string& special, std::size_t most) {
    if (!taken_.insert(name).second) refuse(opened_.name, "contains " + printable_name(name) + " twice");
    if (!special.empty())
      contents_.unusable[name] = special;
    else if (auto bytes = inflate(entry, printable_name(name), most))
      take_(name, std::move(*bytes));
    else
      contents_.unusable[name] = judge::is_too_large(most);
  }

  static std::string printable_name(const std::string& name) { return shorten(printable(name), 100); }

  /// Reads what is left of a member, so that the limits hold for what nobody wants too.
  void skip_data() {
    const void* block = nullptr;
    std::size_t size = 0;
    la_int64_t offset = 0;
    while (archive_read_data_block(reader_.get(), &block, &size, &offset) == ARCHIVE_OK) {
      skipped_ += size;
      if (skipped_ > limits_.skipped_bytes)
        refuse(opened_.name,
               fmt::format("inflates to more than {} bytes besides the steps' files", limits_.skipped_bytes));
    }
  }

  archive_entry* next() {
    const bool seeks = (archive_format(reader_.get()) & ARCHIVE_FORMAT_BASE_MASK) == ARCHIVE_FORMAT_ZIP;
    if (members_ > 0 && !seeks) skip_data();
    archive_entry* entry = nullptr;
    const int status = archive_read_next_header(reader_.get(), &entry);
    if (status == ARCHIVE_EOF) return nullptr;
    if (status < ARCHIVE_WARN) refuse(opened_.name, "is not a complete archive: " + words_of(reader_.get()));
    if (++members_ > limits_.members) refuse(opened_.name, fmt::format("has more than {} members", limits_.members));
    return entry;
  }

  /// Nothing if the member is too large; the rest of it is not read.
  std::optional<std::string> inflate(archive_entry* entry, const std::string& name, std::size_t most) {
    if (archive_entry_is_encrypted(entry))
      refuse(opened_.name, "contains the encrypted file " + name + "; make the archive without a password");
    std::string bytes;
    char block[1 << 14];
    for (;;) {
      const la_ssize_t count = archive_read_data(reader_.get(), block, sizeof block);
      if (count == 0) return bytes;
      if (count < 0) refuse(opened_.name, fmt::format("{} cannot be inflated: {}", name, words_of(reader_.get())));
      bytes.append(block, std::size_t(count));
      total_ += std::size_t(count);
      check_limits(name);
      if (bytes.size() > most) return std::nullopt;
    }
  }

  void check_limits(const std::string& name) const {
    if (total_ > limits_.total_bytes)
      refuse(opened_.name, fmt::format("the steps' files together may have at most {} bytes", limits_.total_bytes));
    if (double(total_) > limits_.ratio * double(opened_.size))
      refuse(opened_.name, fmt::format("{} inflates to more than {:g} times the archive's size; source code never does",
                                       name, limits_.ratio));
  }

  Utf8Locale utf8_;  // before reader_, which reads the locale when it opens the file
  const Opened& opened_;
  const WantedBytes& wanted_;
  const TakeMember& take_;
  ArchiveLimits limits_;
  Archive reader_;
  std::size_t total_ = 0, skipped_ = 0;
  int members_ = 0;
  std::set<std::string> taken_;
  ArchiveContents contents_;
};

/// The ending of an archive's name; empty if it has none.
std::string archive_ending(const std::string& name) {
  std::string ending = fs::path(name).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  static const std::set<std::string> endings = {".zip", ".tar", ".gz",  ".tgz", ".xz",  ".txz",
                                                ".7z",  ".rar", ".bz2", ".tbz", ".zst", ".zipx"};
  return endings.contains(ending) ? ending : "";
}

}  // namespace

ArchiveContents read_archive(const fs::path& file, const WantedBytes& wanted, const TakeMember& take,
                             const ArchiveLimits& limits) {
  std::string first;
  const Opened opened = open_file(file, first);
  return ArchiveReader(opened, wanted, take, limits).read();
}

ArchiveContents read_archive(const std::string& name, std::string_view bytes, const WantedBytes& wanted,
                             const TakeMember& take, const ArchiveLimits& limits) {
  const Opened opened = {.name = name, .file = {}, .bytes = bytes, .size = bytes.size()};
  return ArchiveReader(opened, wanted, take, limits).read();
}

bool has_archive_name(const std::string& name) {
  return !archive_ending(name).empty();
}

std::string without_archive_endings(const std::string& name) {
  fs::path path = name;
  while (has_archive_name(path.string()) && path.stem() != path) path = path.stem();
  return path.string();
}

}  // namespace atelier::grade
