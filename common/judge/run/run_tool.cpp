#include "judge/run/run_tool.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "base/error.hpp"
#include "base/launch.hpp"
#include "base/printable.hpp"
#include "base/process.hpp"
#include "judge/run/build.hpp"

namespace atelier::judge {
namespace {

/// Compiler messages in English with plain quotes, whatever the user's locale, so that reports do not depend on it.
std::map<std::string, std::string> compiler_environment(bool confined) {
  if (confined) return {{"LC_ALL", "C"}, {"PATH", "/usr/bin:/bin"}};
  std::map<std::string, std::string> environment = {{"LC_ALL", "C"}};
  for (const char* name : {"PATH", "HOME", "TMPDIR", "CCACHE_DIR"})
    if (const char* value = std::getenv(name)) environment[name] = value;
  return environment;
}

/// What the sandbox adds to the words of a tool goes to `log`.
Finished run_confined(const Launch& wanted, const std::string& task, const ToolSettings& settings,
                      const sandbox::Room& room, std::string& log) {
  const sandbox::Sandbox& sandbox = *settings.sandbox;
  const bool alone = sandbox.is_idle();
  const int kills = sandbox.memory_kills();
  sandbox::Confined confined = sandbox.confine(wanted, room);
  Finished finished = run_process({.arguments = confined.launch.arguments,
                                   .folder = confined.launch.folder,
                                   .environment = confined.launch.environment,
                                   .time_limit = settings.time_limit,
                                   .output_limit = log_limit,
                                   .descriptors = confined.launch.descriptors});
  sandbox.program_ended();
  const bool out_of_memory = sandbox.memory_kills() > kills;
  if (!confined.was_started() && alone && !out_of_memory)
    throw Error("the sandbox did not start the compiler: " + sandbox::failure_of_sandbox(finished.output));
  if (out_of_memory)
    log = fmt::format("{}: the compiler needed more than {} of memory\n", task,
                      sandbox::in_words(sandbox.limits().memory));
  if (finished.signal == 0) finished.signal = sandbox::signal_of_status(finished.exit_status);
  if (finished.signal != 0) finished.exit_status = -1;
  return finished;
}

}  // namespace

sandbox::Room room_of_tools(const std::vector<std::string>& options, const std::filesystem::path& objects) {
  sandbox::Room room;
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (options[i].starts_with("-I")) room.readable.push_back(options[i].substr(2));
    if (i == 0) continue;
    if (options[i - 1] == "-iquote") room.readable.push_back(options[i]);
    if (options[i - 1] == "-include") room.readable.push_back(std::filesystem::path(options[i]).parent_path());
  }
  room.writable = {objects};
  return room;
}

bool run_tool(std::vector<std::string> arguments, const std::filesystem::path& folder, const std::string& task,
              const ToolSettings& settings, sandbox::Room room, std::string& log) {
  const bool confined = settings.sandbox && settings.sandbox->tier() != sandbox::Tier::none;
  const Launch wanted{.arguments = std::move(arguments),
                      .folder = folder,
                      .environment = compiler_environment(confined),
                      .descriptors = {}};
  room.readable.push_back(folder);
  log.clear();
  const Finished finished = confined ? run_confined(wanted, task, settings, room, log)
                                     : run_process({.arguments = wanted.arguments,
                                                    .folder = wanted.folder,
                                                    .environment = wanted.environment,
                                                    .time_limit = settings.time_limit,
                                                    .output_limit = log_limit});
  log += printable(finished.output, Layout::keep_lines);
  if (finished.timed_out)
    log = fmt::format("{}: took longer than {} s and was killed\n", task, settings.time_limit.count() / 1000.0) + log;
  else if (finished.signal != 0)
    log = fmt::format("{}: the compiler crashed: {}\n", task, signal_name(finished.signal)) + log;
  else if (!finished.ok() && log.empty())
    log = fmt::format("{}: failed with status {} and no message\n", task, finished.exit_status);
  return finished.ok();
}

}  // namespace atelier::judge
