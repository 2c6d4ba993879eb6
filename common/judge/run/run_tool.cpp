#include "judge/run/run_tool.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "base/printable.hpp"
#include "base/process.hpp"
#include "judge/run/build.hpp"

namespace atelier::judge {
namespace {

/// Compiler messages in English with plain quotes, whatever the user's locale, so that reports do not depend on it.
std::map<std::string, std::string> compiler_environment() {
  std::map<std::string, std::string> environment = {{"LC_ALL", "C"}};
  for (const char* name : {"PATH", "HOME", "TMPDIR", "CCACHE_DIR"})
    if (const char* value = std::getenv(name)) environment[name] = value;
  return environment;
}

}  // namespace

bool run_tool(std::vector<std::string> arguments, const std::filesystem::path& folder, const std::string& task,
              std::chrono::milliseconds time_limit, std::string& log) {
  const Finished finished = run_process({.arguments = std::move(arguments),
                                         .folder = folder,
                                         .environment = compiler_environment(),
                                         .time_limit = time_limit,
                                         .output_limit = log_limit});
  log = printable(finished.output, Layout::keep_lines);
  if (finished.timed_out)
    log = fmt::format("{}: took longer than {} s and was killed\n", task, time_limit.count() / 1000.0) + log;
  else if (finished.signal != 0)
    log = fmt::format("{}: the compiler crashed: {}\n", task, signal_name(finished.signal)) + log;
  else if (!finished.ok() && log.empty())
    log = fmt::format("{}: failed with status {} and no message\n", task, finished.exit_status);
  return finished.ok();
}

}  // namespace atelier::judge
