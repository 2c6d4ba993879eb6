#include "app/window/restart.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <system_error>
#if defined(__APPLE__)
#include <mach-o/dyld.h>
#endif

#include "base/error.hpp"
#include "base/process.hpp"
#include "base/system_reason.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

void look_at_file(Snapshot& snapshot, const fs::path& file) {
  std::error_code gone;
  const auto changed = fs::last_write_time(file, gone);
  if (gone) return;
  const auto size = fs::file_size(file, gone);
  if (!gone) snapshot[file] = {changed, size};
}

bool is_shader(const fs::path& file) {
  static const std::set<std::string> extensions = {".glsl", ".vert", ".frag", ".geom"};
  return extensions.contains(file.extension().string());
}

std::string vector_text(const glm::dvec3& v) {
  return fmt::format("{},{},{}", v.x, v.y, v.z);
}

}  // namespace

Snapshot step_libraries(const StepIdentity& identity, const Implementations& implementations) {
  Snapshot snapshot;
  for (const std::string& step : identity.libraries) {
    const fs::path library = implementations.find(step + "/libstep.so");
    if (!library.empty()) look_at_file(snapshot, library);
  }
  return snapshot;
}

Snapshot step_shaders(const Implementations& implementations) {
  Snapshot snapshot;
  std::error_code missing;  // a folder that disappears counts as empty
  for (const Implementations::Root& root : implementations.roots())
    for (const auto& step : fs::directory_iterator(root.folder, missing)) {
      const std::string name = step.path().filename().string();
      if (!root.only.empty() && root.only != name && !root.only.starts_with(name + "/")) continue;
      for (const auto& file : fs::directory_iterator(step.path(), missing))
        if (is_shader(file.path()) && root.applies_to(name + "/" + file.path().filename().string()))
          look_at_file(snapshot, file.path());
    }
  return snapshot;
}

bool Watch::settled_change(const Snapshot& now) {
  const bool at_rest = now == last_;
  last_ = now;
  if (!at_rest || now == known_) return false;
  known_ = now;
  return true;
}

std::vector<std::string> to_arguments(const CommandLine& line) {
  std::vector<std::string> arguments;
  const auto add = [&](const char* option, const std::string& value) {
    // One argument: a value that begins with a minus sign would be parsed as an option.
    if (!value.empty()) arguments.push_back(fmt::format("{}={}", option, value));
  };
  const Case& picture = line.picture;
  add("--scene", picture.scene);
  add("--size", fmt::format("{}x{}", picture.size.x, picture.size.y));
  add("--output", picture.output);
  if (picture.camera.eye) add("--eye", vector_text(*picture.camera.eye));
  if (picture.camera.target) add("--target", vector_text(*picture.camera.target));
  for (const auto& [name, text] : line.settings) add("--set", name + "=" + text);
  if (line.context) add("--context", to_string(*line.context));
  if (line.implementations) add("--implementations", line.implementations->to_string());
  return arguments;
}

fs::path this_program() {
#if defined(__APPLE__)
  std::uint32_t size = 0;
  _NSGetExecutablePath(nullptr, &size);
  std::string path(size, '\0');
  if (_NSGetExecutablePath(path.data(), &size) == 0) return fs::canonical(path.c_str());
#else
  std::error_code failed;
  const fs::path path = fs::read_symlink("/proc/self/exe", failed);
  if (!failed) return path;
#endif
  throw Error("the file of the running program cannot be found: restart it to use the new code");
}

std::string why_not_loadable(const fs::path& program, const CommandLine& line) {
  std::vector<std::string> arguments = {program.string(), "--list"};
  if (line.implementations) arguments.push_back("--implementations=" + line.implementations->to_string());
  const Finished list = run_process({.arguments = arguments, .time_limit = std::chrono::seconds(10)});
  if (list.ok()) return {};
  if (list.timed_out) return "the new code does not start within 10 s";
  if (list.signal) return "the new code cannot be loaded: " + signal_name(list.signal);
  return list.output;
}

void restart(const fs::path& program, const CommandLine& line) {
  std::vector<std::string> words = to_arguments(line);
  words.insert(words.begin(), program.string());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execv(program.c_str(), pointers.data());
  throw Error(fmt::format("{}: cannot be restarted: {}", program.string(), system_reason()));
}

}  // namespace atelier
