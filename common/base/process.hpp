// Runs child processes without a shell, with limits on time and output; the whole process group is killed at the end.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/launch.hpp"

namespace atelier {

struct Command {
  std::vector<std::string> arguments;                             ///< the program (searched in PATH) and its arguments
  std::filesystem::path folder;                                   ///< working directory; empty: the parent's
  std::optional<std::map<std::string, std::string>> environment;  ///< the whole environment; none: the parent's
  std::chrono::milliseconds time_limit{600'000};                  ///< wall-clock; then SIGKILL to the process group
  std::size_t output_limit = 1 << 20;  ///< bytes of stdout and stderr to keep (the rest is read and discarded)
  std::vector<PassedDescriptor> descriptors = {};  ///< what it inherits besides
};

struct Finished {
  int exit_status = 0;  ///< -1 if a signal or the time limit ended it
  int signal = 0;       ///< the signal that ended it, or 0
  bool timed_out = false;
  std::string output;  ///< stdout and stderr interleaved, at most output_limit bytes
  double seconds = 0;  ///< wall-clock time
  bool ok() const { return exit_status == 0 && !timed_out && signal == 0; }
};

/// Runs the program and waits for its end. Throws Error, with the system's reason, only if it cannot be started.
Finished run_process(const Command& command);

/// A signal in words: "segmentation fault (SIGSEGV)".
std::string signal_name(int signal);

}  // namespace atelier
