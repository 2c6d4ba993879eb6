// Reads wanted members of an untrusted archive into memory, with limits on their size: ZIP, tar, tar.gz, tar.xz or 7z.
//
// Nothing is written to a path that the archive names, so a malicious path can do no harm.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "judge/run/source_file.hpp"

namespace atelier::grade {

/// Limits on an archive. Bytes are counted while a member inflates; the size in its header is not trusted.
struct ArchiveLimits {
  std::size_t archive_bytes = 64 << 20;
  int members = 10'000;                            ///< listed, wanted or not
  std::size_t member_bytes = judge::source_limit;  ///< of one wanted member, inflated
  std::size_t total_bytes = 16 << 20;              ///< of all wanted members together
  std::size_t skipped_bytes = 256 << 20;           ///< of all others
  double ratio = 200;  ///< inflated bytes per byte of the archive; text deflates to about a tenth at best
};

struct ArchiveContents {
  std::map<std::string, std::string> files;  ///< bytes by wanted name, "NN-name/FILE"
  judge::UnusableFiles unusable;             ///< wanted members that are unusable, and why
  std::vector<std::string> skipped;          ///< suspicious other members, each with the reason; printable
  std::vector<std::string> names;            ///< of all members, unchanged
};

/// The wanted members of an archive. All may have the same folders in front ("ada/hw/02-blinn-phong/blinn_phong.cpp").
/// Where there are several such folders, the wanted members are those with the fewest folders in front; the others,
/// such as copies, are skipped and reported. What Macs and version control put beside them (__MACOSX/, .git/) is
/// ignored. Wanted members that are links, special files or larger than limits.member_bytes are unusable. Members with
/// an absolute path or "..", and unwanted links and special files, are skipped and reported; other unwanted members are
/// ignored. Throws Error naming the archive and the member, if one is to blame: empty, no archive, cut off, encrypted,
/// over another limit, a wanted name twice, two folders with steps side by side.
ArchiveContents read_archive(const std::filesystem::path& file, const std::set<std::string>& wanted,
                             const ArchiveLimits& limits = {});

}  // namespace atelier::grade
