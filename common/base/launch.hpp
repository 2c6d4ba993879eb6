// Starts a child process. base/process.hpp waits for its end; judge/run/worker.hpp communicates with it while it runs.
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

/// Both ends are close-on-exec from the start, so that a child started by another thread does not inherit them, and
/// have numbers above those of the standard streams. Throws Error with the system's reason.
Pipe make_pipe();

/// A descriptor that the child inherits: its number in this process, and its number in the child.
struct PassedDescriptor {
  int parent_number = -1, child_number = 0;  ///< child_number: 0..15
};

/// The absolute path of a program: a name with a slash is a path, any other name is searched for in PATH, which exec
/// cannot do for a child with another working directory and environment. Throws Error if it is not found.
std::filesystem::path find_program(const std::string& name);

struct Launch {
  std::vector<std::string> arguments;                             ///< the program (searched in PATH) and its arguments
  std::filesystem::path folder;                                   ///< working directory; empty: the parent's
  std::optional<std::map<std::string, std::string>> environment;  ///< the whole environment; none: the parent's
  std::vector<PassedDescriptor> descriptors;  ///< all that the child inherits; its standard input is empty by default
};

/// Starts a program without a shell, and returns once it runs. The child leads its own process group, is killed when
/// the thread that started it ends, and has default signal handling with none blocked. The caller must wait for it.
/// Throws Error naming the program and the system's reason if it cannot be started.
pid_t launch(const Launch& wanted);

/// Kills a child of `launch` and its process group, even if the child has left the group, and waits for the child.
/// Returns its status as waitpid does.
int kill_and_wait(pid_t child);

/// The environment of this process, by name.
std::map<std::string, std::string> own_environment();

}  // namespace atelier
