// Hot reload: detects changed shader files and step libraries, and restarts the program.
//
// A loaded library cannot be replaced safely (the scene may hold pointers into it), but the program starts in 0.1 s: it
// executes itself again, with the same view on its command line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/load.hpp"

namespace atelier {

/// Modification time and size of files at one time. Missing files are left out.
struct FileState {
  std::filesystem::file_time_type changed;
  std::uintmax_t size;
  bool operator==(const FileState&) const = default;
};
using Snapshot = std::map<std::filesystem::path, FileState>;

/// The program's step libraries: NN-name/libstep.so for each of identity.libraries. One may be missing while it is
/// built: linkers delete before they write.
Snapshot step_libraries(const StepIdentity& identity, const Implementations& implementations);

/// The shader files (.glsl .vert .frag .geom) in the NN-name/ folders of every root of the search path.
Snapshot step_shaders(const Implementations& implementations);

/// Reports once when a set of files has changed and is then stable: a library changes while the linker is writing it.
class Watch {
 public:
  explicit Watch(Snapshot now) : known_(now), last_(std::move(now)) {}
  /// True if `now` differs from the last reported state and equals the previous one.
  bool settled_change(const Snapshot& now);

 private:
  Snapshot known_, last_;
};

/// The arguments from which parse_command_line recreates `line`; only those that a window needs.
std::vector<std::string> to_arguments(const CommandLine& line);

/// The file of the running program.
std::filesystem::path this_program();

/// Empty if the program can load the code on disk, otherwise its error message. Runs a child process.
std::string why_not_loadable(const std::filesystem::path& program, const CommandLine& line);

/// Replaces this process by `program`. Returns only by throwing Error.
[[noreturn]] void restart(const std::filesystem::path& program, const CommandLine& line);

}  // namespace atelier
