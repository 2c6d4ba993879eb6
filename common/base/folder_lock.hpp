// A lock on a folder, so that one process at a time changes it.
#pragma once

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/descriptor.hpp"

namespace atelier {

/// The constructor waits for the lock; the destructor, or the end of the process, releases it. On a file system without
/// locks nothing is locked.
class FolderLock {
 public:
  /// The lock, or nothing if another process has it.
  static std::optional<FolderLock> try_lock(const std::filesystem::path& folder) {
    FolderLock lock(open(folder));
    if (lock.folder_ && ::flock(lock.folder_.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      return std::nullopt;
    return lock;
  }

  explicit FolderLock(const std::filesystem::path& folder) : folder_(open(folder)) {
    while (folder_ && ::flock(folder_.get(), LOCK_EX) != 0 && errno == EINTR) {
    }
  }

 private:
  explicit FolderLock(Descriptor folder) : folder_(std::move(folder)) {}
  static Descriptor open(const std::filesystem::path& folder) {
    return Descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  }

  Descriptor folder_;
};

}  // namespace atelier
