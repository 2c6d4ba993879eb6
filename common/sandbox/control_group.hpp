// A control group of Linux: limits on the memory and the number of processes of all programs in it together.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace atelier::sandbox {

class ControlGroup {
 public:
  /// The name of a group of this process; it says whose it is, also to other processes.
  static std::string name_of(const std::string& ending);

  /// A new group in the hierarchies below `root`, version 1 or 2, whose name has `ending`; null where this process may
  /// not make one.
  static std::unique_ptr<ControlGroup> create(const std::string& ending, std::size_t memory, int processes,
                                              const std::filesystem::path& root = "/sys/fs/cgroup",
                                              const std::filesystem::path& own = "/proc/self/cgroup");
  ~ControlGroup();  ///< kills all processes in it and removes it
  ControlGroup(const ControlGroup&) = delete;
  ControlGroup& operator=(const ControlGroup&) = delete;

  /// The folders into whose file cgroup.procs a process writes its number to be in the group.
  const std::vector<std::filesystem::path>& folders() const { return folders_; }

  void kill_all() const;     ///< and waits until they are gone, at most a second
  int memory_kills() const;  ///< how many processes of the group the system has killed for want of memory

  /// Removes the groups that processes which have ended did not remove, and kills what is in them.
  static void remove_abandoned(const std::filesystem::path& root = "/sys/fs/cgroup");

 private:
  ControlGroup() = default;
  std::vector<std::filesystem::path> folders_;
};

}  // namespace atelier::sandbox
