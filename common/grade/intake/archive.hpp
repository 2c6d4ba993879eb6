// Reads wanted members of an untrusted archive, with limits on their size: ZIP, tar, tar.gz, tar.xz or 7z.
//
// Nothing is written to a path that the archive names, so a malicious path can do no harm.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "judge/run/source_file.hpp"

namespace atelier::grade {

/// Limits on an archive. Bytes are counted while a member inflates; the size in its header is not trusted.
struct ArchiveLimits {
  std::size_t archive_bytes = 64 << 20;
  int members = 10'000;                   ///< listed, wanted or not
  std::size_t total_bytes = 16 << 20;     ///< of all wanted members together
  std::size_t skipped_bytes = 256 << 20;  ///< of all others
  double ratio = 200;  ///< inflated bytes per byte of the archive; text deflates to about a tenth at best
};

/// The most bytes, inflated, that are read of the member with this name; none: it is not wanted.
using WantedBytes = std::function<std::size_t(const std::string& name)>;

/// Takes a wanted member as soon as it is read.
using TakeMember = std::function<void(const std::string& name, std::string bytes)>;

struct ArchiveContents {
  judge::UnusableFiles unusable;     ///< wanted members that are unusable, and why; names unchanged
  std::vector<std::string> skipped;  ///< suspicious other members, each with the reason; printable
  std::vector<std::string> names;    ///< of all members but those that lead out, unchanged without "./" in front
  std::size_t inflated = 0;          ///< bytes of all members that were inflated
};

/// Passes the wanted members of an archive to `take`. Members in what Macs and version control keep (__MACOSX/, .git/)
/// are not wanted. Wanted members that are links, special files or too large are unusable. Members with an absolute
/// path or "..", and unwanted links and special files, are skipped and reported. Throws Error naming the archive and
/// the member, if one is to blame: empty, no archive, cut off, encrypted, over another limit, a wanted name twice.
ArchiveContents read_archive(const std::filesystem::path& file, const WantedBytes& wanted, const TakeMember& take,
                             const ArchiveLimits& limits = {});

/// The same of an archive in memory; messages call it `name`.
ArchiveContents read_archive(const std::string& name, std::string_view bytes, const WantedBytes& wanted,
                             const TakeMember& take, const ArchiveLimits& limits = {});

/// Whether a file's name ends as an archive's does, also of a kind that is not read: ".zip", ".tar.gz", ".rar".
bool has_archive_name(const std::string& name);

/// The name without the endings of archives: "ada" for "ada.tar.gz". Unchanged if nothing else would be left.
std::string without_archive_endings(const std::string& name);

}  // namespace atelier::grade
