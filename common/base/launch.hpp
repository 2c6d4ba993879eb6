// Starting a child process: what everything that runs another program has in common. base/process.hpp waits for one to
// end; judge/run/worker.hpp listens to one while it runs.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/descriptor.hpp"

namespace atelier {

struct Pipe {
  Descriptor read, write;
};

/// Both ends close-on-exec from the start, so that a child started meanwhile by another thread inherits neither, and
/// above the numbers of the standard streams. Throws Error with the system's reason.
Pipe make_pipe();

/// A descriptor of ours, and the number under which the child finds it.
struct Passed {
  int ours = -1, number = 0;  ///< `number`: 0..15
};

struct Launch {
  std::vector<std::string> arguments;                             ///< the program (found along PATH) and its arguments
  std::filesystem::path folder;                                   ///< working directory; empty: the parent's
  std::optional<std::map<std::string, std::string>> environment;  ///< the whole environment; none: the parent's
  std::vector<Passed> descriptors;  ///< all that the child inherits; without a standard input it gets an empty one
};

/// Starts a program without a shell, and returns once it runs. It leads a process group of its own number, dies with
/// the thread that started it, and has default signals, none blocked. It stays ours until it is waited for. Throws
/// Error naming the program and the system's reason where it cannot be started.
pid_t launch(const Launch& wanted);

/// Kills a child of `launch` with its process group, also where it has left that, and waits for it. Returns its status
/// as waitpid gives it.
int kill_and_wait(pid_t child);

/// Our own environment, by name.
std::map<std::string, std::string> own_environment();

}  // namespace atelier
