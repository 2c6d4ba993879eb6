// Detects changed files, whether an editor writes them in place or writes a new file and renames it.
//
// A file has changed if its size, time or inode number has. Notifications of the system only say when to check. Where
// there are none (network drives, a host's folder in a virtual machine), check every `poll_interval`.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "base/descriptor.hpp"

namespace atelier {

class FileWatch {
 public:
  /// How often a caller should check if `descriptor` reports nothing.
  static constexpr std::chrono::milliseconds poll_interval{200};

  /// Watches these files. They need not exist; a file that is created or deleted counts as changed.
  explicit FileWatch(std::vector<std::filesystem::path> files);

  /// Becomes readable when something in the files' folders changes; -1 if the system cannot notify.
  int descriptor() const { return notifications_.get(); }

  /// The files that have changed since the last call, in the order given. Never waits.
  std::vector<std::filesystem::path> take_changes();

 private:
  /// Identifies a state of a file; none if the file does not exist.
  struct Stamp {
    std::uint64_t size = 0, number = 0;
    std::int64_t seconds = 0, nanoseconds = 0;
    bool operator==(const Stamp&) const = default;
  };
  static std::optional<Stamp> stamp(const std::filesystem::path& file);

  std::vector<std::filesystem::path> files_;
  std::map<std::filesystem::path, std::optional<Stamp>> seen_;
  Descriptor notifications_;
};

}  // namespace atelier
