// A running step program: started without a shell, read from while it runs, killed with its process group.
//
// The program reports its progress on a separate pipe, the descriptor `progress_descriptor`; its printed output has no
// meaning. base/process.hpp is for programs that are only waited for.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "base/descriptor.hpp"
#include "base/launch.hpp"
#include "sandbox/sandbox.hpp"

namespace atelier::judge {

inline constexpr int progress_descriptor = 3;  ///< number of the progress pipe in the program

/// How a program ended; `signal` is 0 if it exited.
struct Exit {
  int status = 0;
  int signal = 0;
};

class Worker {
 public:
  /// Starts it with a pipe for its output and one for its progress; its stdin is empty. It runs confined if there is a
  /// sandbox, in this room; if that does not start it, the worker has ended. Throws Error naming the program and the
  /// system's reason if it cannot be started.
  explicit Worker(Launch wanted, const sandbox::Sandbox* sandbox = nullptr, const sandbox::Room& room = {});
  ~Worker();  ///< kills the program and all that it has started, and waits for it
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Descriptors to poll for reading; -1 once the program has closed its side.
  int progress() const { return progress_.get(); }
  int output() const { return output_.get(); }

  /// Reads what is available without waiting, at most 64 KiB per call. take_lines returns complete lines without their
  /// line end, and drops lines that are too long for the protocol.
  std::vector<std::string> take_lines();
  std::string take_output();

  /// How it ended, or nothing while it runs. Never waits.
  std::optional<Exit> ended();

  /// Kills the program and all that it has started at once, and waits for it.
  void kill();

  /// Once it has ended: whether the sandbox has started the program at all.
  bool was_started() { return confined_.was_started(); }

  /// The folder of answers, where it exists only in the sandbox; at most once.
  Descriptor take_answers() { return std::move(answers_); }

 private:
  pid_t child_ = -1;  ///< leads a process group of the same number
  std::optional<Exit> exit_;
  Descriptor progress_, output_, answers_;
  const sandbox::Sandbox* sandbox_;
  sandbox::Confined confined_;
  std::string line_;  ///< the beginning of an incomplete line
};

}  // namespace atelier::judge
