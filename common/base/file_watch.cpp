#include "base/file_watch.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <set>
#if defined(__linux__)
#include <sys/inotify.h>
#endif

namespace atelier {

FileWatch::FileWatch(std::vector<std::filesystem::path> files) : files_(std::move(files)) {
  for (const auto& file : files_) seen_[file] = stamp(file);
#if defined(__linux__)
  notifications_ = Descriptor(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
  if (!notifications_) return;
  // Watch folders, not files: an editor that writes a new file and renames it replaces the watched inode.
  std::set<std::filesystem::path> folders;
  for (const auto& file : files_) folders.insert(file.has_parent_path() ? file.parent_path() : ".");
  for (const auto& folder : folders)
    ::inotify_add_watch(notifications_.get(), folder.c_str(),
                        IN_CLOSE_WRITE | IN_MODIFY | IN_MOVED_TO | IN_MOVED_FROM | IN_CREATE | IN_DELETE);
#endif
}

std::optional<FileWatch::Stamp> FileWatch::stamp(const std::filesystem::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) return {};
#if defined(__APPLE__)
  const timespec& time = found.st_mtimespec;
#else
  const timespec& time = found.st_mtim;
#endif
  return Stamp{.size = std::uint64_t(found.st_size),
               .number = std::uint64_t(found.st_ino),
               .seconds = std::int64_t(time.tv_sec),
               .nanoseconds = std::int64_t(time.tv_nsec)};
}

std::vector<std::filesystem::path> FileWatch::take_changes() {
  if (notifications_) {
    std::array<char, 4096> ignored;
    while (::read(notifications_.get(), ignored.data(), ignored.size()) > 0) {
    }
  }
  std::vector<std::filesystem::path> changed;
  for (const auto& file : files_)
    if (const auto now = stamp(file); now != seen_[file]) {
      seen_[file] = now;
      changed.push_back(file);
    }
  return changed;
}

}  // namespace atelier
