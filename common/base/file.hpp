// Reads and writes whole files; writes are atomic.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/held_folder.hpp"

namespace atelier {

/// The bytes of a regular file. Throws Error naming the path if it is missing, unreadable, not a regular file or larger
/// than `limit` bytes.
std::string read_file(const std::filesystem::path& path, std::size_t limit = std::size_t(1) << 30);

/// Atomic write: writes a temporary file in the same folder and renames it. A reader sees either the old or the new
/// file, and a full disk leaves the old one unchanged. Creates missing parent folders. Throws Error naming the path and
/// the system's reason.
void write_file(const std::filesystem::path& path, std::string_view bytes);
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes what writes to files of this folder have left that were killed. No other process may be writing there.
void remove_unfinished_files(const std::filesystem::path& folder);

/// Throws Error if the disk that holds `folder` has fewer than `bytes` free: a failure for lack of space must not be
/// reported as a student's mistake.
void require_space(const std::filesystem::path& folder, std::uintmax_t bytes);
inline constexpr std::uintmax_t working_space = 32 << 20;  ///< enough for a step's build or its pictures
inline constexpr std::uintmax_t min_free_space = 1 << 20;  ///< with less free, a write may have failed

/// A path that does not exist yet: `path` + `ending`, or if that exists, `path` + `ending` + "-2", "-3" ...
std::filesystem::path free_path(const std::filesystem::path& path, const std::string& ending);

/// Where temporary folders are made. Throws Error if TMPDIR names no folder.
std::filesystem::path temporary_parent();

/// A new empty folder in the system's temporary folder. The destructor removes it with its contents; if a program has
/// moved it and put a link in its place, still its own contents, and nothing that the link leads to.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(std::string_view prefix = "atelier");
  ~TemporaryFolder();
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  const std::filesystem::path& path() const { return folder_->path(); }
  const HeldFolder& held() const { return *folder_; }

 private:
  std::optional<HeldFolder> folder_;  ///< none: moved from
};

}  // namespace atelier
