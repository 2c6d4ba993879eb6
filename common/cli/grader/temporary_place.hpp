// Where a run that grades a class makes its temporary folders.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "base/held_folder.hpp"

namespace atelier {

/// A folder in the system's temporary folder, for this process and those that it starts: TMPDIR of this process, until
/// the destructor removes it. A run that is killed leaves it behind; so its path is written to a file before it is
/// made, and the next run with this file removes it.
class TemporaryPlace {
 public:
  /// The only one of this process, made before it has threads. Throws Error if it cannot be made.
  explicit TemporaryPlace(std::filesystem::path file);
  ~TemporaryPlace();
  TemporaryPlace(const TemporaryPlace&) = delete;
  TemporaryPlace& operator=(const TemporaryPlace&) = delete;

  /// An empty folder in it; what was in it is removed.
  std::filesystem::path empty_folder(const std::string& name) const;

  /// The environment without this place, for processes on other machines.
  const std::map<std::string, std::string>& environment_before() const { return environment_before_; }

 private:
  std::filesystem::path file_;
  std::map<std::string, std::string> environment_before_;
  std::optional<HeldFolder> folder_;
};

}  // namespace atelier
