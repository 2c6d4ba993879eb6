// Child processes: started without a shell, bounded in time and output, ended with their process group.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace atelier {

struct Command {
  std::vector<std::string> arguments;                             ///< the program (found along PATH) and its arguments
  std::filesystem::path folder;                                   ///< working directory; empty: the parent's
  std::optional<std::map<std::string, std::string>> environment;  ///< the whole environment; none: the parent's
  std::chrono::milliseconds time_limit{600'000};                  ///< of wall clock; then SIGKILL to its process group
  std::size_t output_limit = 1 << 20;  ///< bytes of stdout and stderr kept (the rest is read and dropped)
};

struct Finished {
  int exit_status = 0;  ///< what it exited with; -1 where a signal or the time limit ended it
  int signal = 0;       ///< the signal that ended it, or 0
  bool timed_out = false;
  std::string output;  ///< stdout and stderr as they came, at most output_limit bytes
  double seconds = 0;  ///< wall clock
  bool ok() const { return exit_status == 0 && !timed_out && signal == 0; }
};

/// Runs to the end. Throws Error only where the program cannot be started at all (naming it and the system's reason).
Finished run_process(const Command& command);

/// "segmentation fault (SIGSEGV)" for a signal number.
std::string signal_name(int signal);

}  // namespace atelier
