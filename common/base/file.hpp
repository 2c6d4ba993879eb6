// Whole files, read and written so that nothing is ever half there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace atelier {

/// The bytes of a regular file. Throws Error naming the path where it is missing, unreadable, no regular file or larger
/// than `limit` bytes.
std::string read_file(const std::filesystem::path& path, std::size_t limit = std::size_t(1) << 30);

/// Writes beside the target and renames, so that a reader sees the old file or the new one and never a part, and a full
/// disk leaves the old one as it was. Makes missing parent folders. Throws Error naming the path and the system's
/// reason.
void write_file(const std::filesystem::path& path, std::string_view bytes);
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Throws Error where the disk that `folder` lies on has fewer than `bytes` left: what fails for want of space must not
/// look like somebody's mistake.
void require_space(const std::filesystem::path& folder, std::uintmax_t bytes);
inline constexpr std::uintmax_t space_to_work = 32 << 20;  ///< what a step's build or pictures may take, generously
inline constexpr std::uintmax_t space_left = 1 << 20;      ///< less, and something may not have been written

/// A path beside `path` that nothing has yet: with `ending` behind its name, and "-2", "-3" ... where that is taken.
std::filesystem::path free_path(const std::filesystem::path& path, const std::string& ending);

/// A new empty folder below the system's temporary folder, removed with all that is in it at the end of the scope.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(std::string_view prefix = "atelier");
  ~TemporaryFolder();
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace atelier
