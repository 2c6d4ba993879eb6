// A folder that one process at a time may change.
#pragma once

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <filesystem>

#include "base/descriptor.hpp"

namespace atelier {

/// Waits until no other process holds the folder, and holds it to the end of the scope, or of this process. Where the
/// file system knows no locks nothing is held: two commands at a time are then as they were without it.
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
