// Unpacks the archive of a whole class, as a course platform delivers it, into a folder of its own.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "grade/intake/archive.hpp"

namespace atelier::grade {

inline constexpr std::size_t class_member_bytes = 64 << 20;  ///< of one file; that of ArchiveLimits::archive_bytes
inline constexpr ArchiveLimits class_limits = {.archive_bytes = std::size_t(4) << 30,
                                               .members = 200'000,
                                               .total_bytes = std::size_t(8) << 30,
                                               .skipped_bytes = std::size_t(8) << 30,
                                               .ratio = 200};

/// Writes all regular files of an archive into `folder`, which must be new; nothing but folders and regular files is
/// made, and nothing outside it. Files that are links, larger than class_member_bytes, or have names that the file
/// system refuses, are `unusable`. Throws Error as read_archive does.
ArchiveContents unpack_archive(const std::filesystem::path& file, const std::filesystem::path& folder,
                               const ArchiveLimits& limits = class_limits);

}  // namespace atelier::grade
