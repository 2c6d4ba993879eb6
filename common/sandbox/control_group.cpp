#include "sandbox/control_group.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "base/file.hpp"

namespace atelier::sandbox {
namespace {

namespace fs = std::filesystem;

bool write_value(const fs::path& file, const std::string& value) {
  std::ofstream stream(file);
  stream << value << std::flush;
  return stream.good();
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// The group of this process in the hierarchy of a controller of version 1, "/a/b"; empty: there is none.
std::string own_group(const fs::path& own, const std::string& controller) {
  std::istringstream lines(text_of(own));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == line.npos) continue;
    std::istringstream controllers(line.substr(first + 1, second - first - 1));
    for (std::string each; std::getline(controllers, each, ',');)
      if (each == controller) return line.substr(second + 1);
  }
  return "";
}

/// Groups are named for the process that makes them, with its namespace of numbers: another container may have the
/// same hierarchy, and processes of the same numbers.
std::string prefix_of_names() {
  std::error_code error;
  std::string space = fs::read_symlink("/proc/self/ns/pid", error).string();  // "pid:[4026531836]"
  std::erase_if(space, [](char c) { return c < '0' || c > '9'; });
  return "atelier-" + space + '-';
}

/// A folder of version 1 with one limit; an empty path without success.
fs::path make_first(const fs::path& root, const fs::path& own, const std::string& name, const char* controller,
                    const char* limit, const std::string& value) {
  const std::string group = own_group(own, controller);
  if (group.empty()) return {};
  const fs::path folder = root / controller / group.substr(1) / name;
  std::error_code error;
  fs::create_directory(folder, error);
  if (!error && write_value(folder / limit, value)) return folder;
  fs::remove(folder, error);
  return {};
}

/// A folder of version 2 with both limits. It lies in the root, whose controllers serve all groups below it: a group
/// that has processes itself, as ours, can have none below it.
fs::path make_second(const fs::path& root, const std::string& name, std::size_t memory, int processes) {
  const std::string controllers = text_of(root / "cgroup.subtree_control");
  if (controllers.find("memory") == controllers.npos || controllers.find("pids") == controllers.npos) return {};
  const fs::path folder = root / name;
  std::error_code error;
  fs::create_directory(folder, error);
  if (!error && write_value(folder / "memory.max", std::to_string(memory)) &&
      write_value(folder / "pids.max", std::to_string(processes)))
    return folder;
  fs::remove(folder, error);
  return {};
}

}  // namespace

std::string ControlGroup::name_of(const std::string& ending) {
  return fmt::format("{}{}-{}", prefix_of_names(), ::getpid(), ending);
}

std::unique_ptr<ControlGroup> ControlGroup::create(const std::string& ending, std::size_t memory, int processes,
                                                   const fs::path& root, const fs::path& own) {
  const std::string name = name_of(ending);
  std::unique_ptr<ControlGroup> group(new ControlGroup);
  const auto add = [&](fs::path folder) {
    if (!folder.empty()) group->folders_.push_back(std::move(folder));
  };
  if (fs::exists(root / "cgroup.controllers")) {
    add(make_second(root, name, memory, processes));
  } else {
    add(make_first(root, own, name, "memory", "memory.limit_in_bytes", std::to_string(memory)));
    add(make_first(root, own, name, "pids", "pids.max", std::to_string(processes)));
  }
  return group->folders_.empty() ? nullptr : std::move(group);
}

ControlGroup::~ControlGroup() {
  kill_all();
  for (const fs::path& folder : folders_) ::rmdir(folder.c_str());
}

void ControlGroup::kill_all() const {
  for (int round = 0; round < 200; ++round) {  // processes that were killed take a moment to be gone
    bool all_gone = true;
    for (const fs::path& folder : folders_) {
      std::istringstream numbers(text_of(folder / "cgroup.procs"));
      for (pid_t process = 0; numbers >> process;) {
        all_gone = false;
        if (process > 1 && process != ::getpid()) ::kill(process, SIGKILL);
      }
    }
    if (all_gone) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

// A group of version 1 lies in that of its maker, such as one session's, and the next grader may be in another one.
void ControlGroup::remove_abandoned(const fs::path& root) {
  const std::string prefix = prefix_of_names();
  const bool second = fs::exists(root / "cgroup.controllers");
  for (const fs::path& place : second ? std::vector{root} : std::vector{root / "memory", root / "pids"}) {
    if (::access(place.c_str(), W_OK) != 0) continue;
    std::error_code error;
    ControlGroup abandoned;  // removes its folders when it ends
    for (fs::recursive_directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error)) {
      const std::string name = entry->path().filename().string();
      const bool made_by_us = name.starts_with("atelier-");
      if (second || made_by_us) entry.disable_recursion_pending();  // it may vanish at any moment
      if (!made_by_us || !name.starts_with(prefix)) continue;
      const pid_t maker = pid_t(std::strtol(name.c_str() + prefix.size(), nullptr, 10));
      if (maker > 1 && ::kill(maker, 0) != 0 && errno == ESRCH) abandoned.folders_.push_back(entry->path());
    }
  }
}

int ControlGroup::memory_kills() const {
  int kills = 0;
  for (const fs::path& folder : folders_)
    for (const char* file : {"memory.oom_control", "memory.events"}) {
      std::istringstream lines(text_of(folder / file));
      std::string key;
      for (int count = 0; lines >> key >> count;)
        if (key == "oom_kill") kills += count;
    }
  return kills;
}

}  // namespace atelier::sandbox
