// A lock on a folder, so that one process at a time changes it.
#pragma once

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <filesystem>

#include "base/descriptor.hpp"

namespace atelier {

/// The constructor waits for the lock; the destructor, or the end of the process, releases it. On a file system without
/// locks nothing is locked.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder)
      : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    while (folder_ && ::flock(folder_.get(), LOCK_EX) != 0 && errno == EINTR) {
    }
  }

 private:
  Descriptor folder_;
};

}  // namespace atelier
