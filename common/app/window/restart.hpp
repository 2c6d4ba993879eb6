// Hot reload: noticing that shader files or step libraries have changed on disk, and starting the program again.
//
// A loaded library cannot be exchanged safely (the scene may hold pointers into it), but the program starts in a tenth
// of a second: it becomes itself again, with the same view on its command line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/load.hpp"

namespace atelier {

/// What files looked like at one time: path to time of change and size. Files that are not there are left out.
struct FileState {
  std::filesystem::file_time_type changed;
  std::uintmax_t size;
  bool operator==(const FileState&) const = default;
};
using Snapshot = std::map<std::filesystem::path, FileState>;

/// The libraries that the program is made of: NN-name/libstep.so for each of identity.libraries. Fewer than that while
/// one is being built: linkers delete before they write.
Snapshot step_libraries(const StepIdentity& identity, const Implementations& implementations);

/// The shader files (.glsl .vert .frag .geom) in the NN-name/ folders of every root of the search path.
Snapshot step_shaders(const Implementations& implementations);

/// Says once when a set of files has changed and come to rest: a library that a linker is still writing changes from
/// look to look.
class Watch {
 public:
  explicit Watch(Snapshot now) : known_(now), last_(std::move(now)) {}
  /// True where `now` differs from what was last reported and equals the look before.
  bool settled_change(const Snapshot& now);

 private:
  Snapshot known_, last_;
};

/// The arguments from which parse_command_line makes `line` again. Only what a window needs.
std::vector<std::string> to_arguments(const CommandLine& line);

/// The file of the running program.
std::filesystem::path this_program();

/// Empty where the program can load its code as it is on disk now, otherwise what it says. Asks a child process.
std::string why_not_loadable(const std::filesystem::path& program, const CommandLine& line);

/// Replaces this process by `program`. Returns only by throwing Error.
[[noreturn]] void restart(const std::filesystem::path& program, const CommandLine& line);

}  // namespace atelier
