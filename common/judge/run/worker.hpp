// One running step program: started without a shell, listened to while it runs, killed with its process group.
//
// The program tells what it is about on a pipe of its own, the descriptor `progress_descriptor`; what it prints is kept
// apart and means nothing. See base/process.hpp for programs that are only waited for.
#pragma once

#include <sys/types.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/descriptor.hpp"

namespace atelier::judge {

inline constexpr int progress_descriptor = 3;  ///< in the program: where its progress lines go

/// How a program ended: `signal` is 0 where it exited by itself.
struct Exit {
  int status = 0;
  int signal = 0;
};

class Worker {
 public:
  /// Starts arguments[0], a path, with exactly this environment; stdin is empty, and no descriptor of ours is
  /// inherited. Throws Error naming the program and the system's reason where it cannot be started.
  Worker(std::vector<std::string> arguments, const std::map<std::string, std::string>& environment);
  ~Worker();  ///< kills the program's process group and waits for the program
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// To be polled for reading; -1 once the program has closed its side.
  int progress() const { return progress_.get(); }
  int output() const { return output_.get(); }

  /// Takes what can be read without waiting, at most 64 KiB a call. Lines come whole and without their end; what is
  /// longer than any line of the protocol is dropped.
  std::vector<std::string> take_lines();
  std::string take_output();

  /// How it ended, or nothing while it runs. Never waits.
  std::optional<Exit> ended();

  /// Kills the program's process group at once and waits for the program.
  void kill();

 private:
  pid_t child_ = -1;  ///< leads a process group of its own number; stays ours until it is reaped
  std::optional<Exit> exit_;
  Descriptor progress_, output_;
  std::string line_;  ///< the begin of a line whose end has not come yet
};

}  // namespace atelier::judge
