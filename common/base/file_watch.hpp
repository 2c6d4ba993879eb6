// Notices when files change, whichever way an editor writes them: in place, or beside and renamed.
//
// What a file's size, time and number say is the truth; notifications of the system only tell when to look. Where none
// come (network drives, a folder of the host inside a virtual machine), looking every `look_again` is enough.
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
  /// How often a caller should look where `descriptor` stays silent.
  static constexpr std::chrono::milliseconds look_again{200};

  /// Watches these files. They need not exist; a file that appears or vanishes has changed.
  explicit FileWatch(std::vector<std::filesystem::path> files);

  /// Becomes readable when something in the files' folders has changed; -1 where the system does not notify.
  int descriptor() const { return notifications_.get(); }

  /// Which files have changed since the last call, in the order given. Never waits.
  std::vector<std::filesystem::path> take_changes();

 private:
  /// What tells two states of a file apart; none for a file that is not there.
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
