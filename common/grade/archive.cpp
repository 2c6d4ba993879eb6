#include "grade/archive.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <locale.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/printable.hpp"
#include "grade/step_places.hpp"

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

/// What the first bytes of a file say.
enum class Kind { zip, empty_zip, tar, seven_zip, other };

struct Looks {
  Kind kind = Kind::other;
  const char* words = "";  ///< "a RAR archive"; empty if unknown
};

Looks looks_of(const std::string& bytes) {
  const auto begins = [&](std::string_view magic) { return bytes.starts_with(magic); };
  if (begins(std::string_view("PK\x03\x04", 4))) return {Kind::zip, "a ZIP"};
  if (begins("PK\x05\x06")) return {Kind::empty_zip, "a ZIP"};
  if (begins("\x1f\x8b") || begins(std::string_view("\3757zXZ\0", 6)) ||
      (bytes.size() > 262 && bytes.compare(257, 5, "ustar") == 0))
    return {Kind::tar, "a tar archive"};
  if (begins("7z\xbc\xaf\x27\x1c")) return {Kind::seven_zip, "a 7z archive"};
  if (begins("Rar!")) return {Kind::other, "a RAR archive"};
  if (begins("BZh")) return {Kind::other, "a bzip2 archive"};
  return {};
}

bool support(archive* reader, Kind kind) {
  switch (kind) {
    case Kind::tar:
      return archive_read_support_format_tar(reader) == ARCHIVE_OK &&
             archive_read_support_filter_gzip(reader) == ARCHIVE_OK &&
             archive_read_support_filter_xz(reader) == ARCHIVE_OK;
    case Kind::seven_zip:
      return archive_read_support_format_7zip(reader) == ARCHIVE_OK;
    default:  // the list of members at the end of the file, as other unpackers do
      return archive_read_support_format_zip_seekable(reader) == ARCHIVE_OK;
  }
}

constexpr const char* what_is_read = "a submission is a folder, or a ZIP, tar, tar.gz, tar.xz or 7z of one";

std::string bytes_of(const fs::path& file, const ArchiveLimits& limits) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) refuse(file, fmt::format("is not a regular file; {}", what_is_read));
  const auto size = fs::file_size(file, error);
  if (error || size > limits.archive_bytes)
    refuse(file, fmt::format("is too large; an archive may have at most {} bytes", limits.archive_bytes));
  if (size == 0) refuse(file, fmt::format("is empty (0 bytes); {}", what_is_read));
  return read_file(file);
}

/// Reads `bytes`, which must outlive it.
Archive open_archive(const fs::path& file, const std::string& bytes) {
  const Looks looks = looks_of(bytes);
  if (looks.kind == Kind::empty_zip) refuse(file, "is an empty archive");
  if (looks.kind == Kind::other)
    refuse(file, *looks.words ? fmt::format("is {}; {}", looks.words, what_is_read)
                              : fmt::format("is no archive; {}", what_is_read));
  Archive reader(archive_read_new(), archive_read_free);
  if (!reader || !support(reader.get(), looks.kind))
    refuse(file, fmt::format("cannot be read: the archive library does not support {}", looks.words));
  if (archive_read_open_memory(reader.get(), bytes.data(), bytes.size()) != ARCHIVE_OK)
    refuse(file, looks.kind == Kind::zip
                     ? "is cut off or damaged: it begins as a ZIP, but the list of members at its end is missing"
                     : fmt::format("is cut off or damaged: it begins as {}", looks.words));
  return reader;
}

/// A wanted member's name, split into the folders in front (`prefix`, empty: none) and the wanted name.
struct Place {
  std::string name, prefix;
};

bool in_folder_of_tools(const std::string& path) {
  return std::ranges::any_of(fs::path(path).parent_path(),
                             [](const fs::path& part) { return is_folder_of_tools(part.string()); });
}

/// Nothing if the member is not wanted.
std::optional<Place> place_of(const std::string& member, const std::set<std::string>& wanted) {
  if (wanted.contains(member)) return Place{member, ""};  // no prefix
  for (auto slash = member.find('/'); slash != member.npos; slash = member.find('/', slash + 1))
    if (wanted.contains(member.substr(slash + 1)) && !in_folder_of_tools(member))
      return Place{member.substr(slash + 1), member.substr(0, slash)};
  return std::nullopt;
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
  ArchiveReader(const fs::path& file, const ArchiveLimits& limits)
      : file_(file), limits_(limits), bytes_(bytes_of(file, limits)), reader_(open_archive(file, bytes_)) {}

  ArchiveContents read(const std::set<std::string>& wanted) {
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
    choose_folder();
    return std::move(contents_);
  }

 private:
  /// What is wanted, behind the same folders.
  struct Found {
    std::map<std::string, std::string> files;
    judge::UnusableFiles unusable;
  };

  /// Takes what has the fewest folders in front.
  void choose_folder() {
    const auto depth = [](const std::string& prefix) {
      return prefix.empty() ? 0 : 1 + std::ranges::count(prefix, '/');
    };
    std::vector<std::string> prefixes;
    for (const auto& [prefix, found] : found_) prefixes.push_back(prefix);
    std::ranges::stable_sort(prefixes, {}, depth);
    if (prefixes.empty()) return;
    if (prefixes.size() > 1 && depth(prefixes[0]) == depth(prefixes[1]))
      refuse(file_, fmt::format("has steps in two folders, '{}' and '{}'; it must be one submission",
                                printable(prefixes[0]), printable(prefixes[1])));
    contents_.files = std::move(found_[prefixes[0]].files);
    contents_.unusable = std::move(found_[prefixes[0]].unusable);
    for (std::size_t i = 1; i < prefixes.size(); ++i) skip(prefixes[i], "has steps too, deeper in the archive");
  }

  void skip(const std::string& name, const std::string& why) {
    contents_.skipped.push_back(shorten(printable(name), 100) + " " + why);
  }

  void take(archive_entry* entry, const Place& place, const std::string& special) {
    Found& found = found_[place.prefix];
    if (found.files.contains(place.name) || found.unusable.contains(place.name))
      refuse(file_, "contains " + place.name + " twice");
    if (!special.empty())
      found.unusable[place.name] = special;
    else if (auto bytes = inflate(entry, place.name))
      found.files[place.name] = std::move(*bytes);
    else
      found.unusable[place.name] = judge::is_too_large(limits_.member_bytes);
  }

  /// Reads what is left of a member, so that the limits hold for what nobody wants too.
  void skip_data() {
    const void* block = nullptr;
    std::size_t size = 0;
    la_int64_t offset = 0;
    while (archive_read_data_block(reader_.get(), &block, &size, &offset) == ARCHIVE_OK) {
      skipped_ += size;
      if (skipped_ > limits_.skipped_bytes)
        refuse(file_, fmt::format("inflates to more than {} bytes besides the steps' files", limits_.skipped_bytes));
    }
  }

  archive_entry* next() {
    const bool seeks = (archive_format(reader_.get()) & ARCHIVE_FORMAT_BASE_MASK) == ARCHIVE_FORMAT_ZIP;
    if (members_ > 0 && !seeks) skip_data();
    archive_entry* entry = nullptr;
    const int status = archive_read_next_header(reader_.get(), &entry);
    if (status == ARCHIVE_EOF) return nullptr;
    if (status < ARCHIVE_WARN) refuse(file_, "is not a complete archive: " + words_of(reader_.get()));
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
    if (double(total_) > limits_.ratio * double(bytes_.size()))
      refuse(file_, fmt::format("{} inflates to more than {:g} times the archive's size; source code never does", name,
                                limits_.ratio));
  }

  Utf8Locale utf8_;  // before reader_, which reads the locale when it opens the file
  fs::path file_;
  ArchiveLimits limits_;
  std::string bytes_;  ///< of the archive
  Archive reader_;
  std::size_t total_ = 0, skipped_ = 0;
  int members_ = 0;
  std::map<std::string, Found> found_;  ///< by the folders in front of the steps' folders
  ArchiveContents contents_;
};

}  // namespace

ArchiveContents read_archive(const fs::path& file, const std::set<std::string>& wanted, const ArchiveLimits& limits) {
  return ArchiveReader(file, limits).read(wanted);
}

}  // namespace atelier::grade
