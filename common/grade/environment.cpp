#include "grade/environment.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <cstdlib>
#include <fstream>
#include <map>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/launch.hpp"
#include "base/printable.hpp"
#include "base/process.hpp"
#include "base/strict_json.hpp"
#include "gl/context.hpp"
#include "judge/run/runner.hpp"

namespace atelier::grade {
namespace {

namespace fs = std::filesystem;

std::string first_line(const std::string& text) {
  return printable(text.substr(0, text.find('\n')));
}

std::string describe_cpu() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (const std::size_t colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos)
      return printable(line.substr(colon + 2));
  return "unknown";
}

std::string describe_system() {
  utsname system{};
  if (::uname(&system) != 0) return "unknown";
  return fmt::format("{} {}", system.sysname, system.machine);
}

std::string describe_compiler(const fs::path& step_flags) {
  const strict_json::Json flags = strict_json::parse(read_file(step_flags, 1 << 20), step_flags.string());
  const strict_json::Json* version = flags.is_object() ? strict_json::optional(flags, "compiler_version") : nullptr;
  return version ? strict_json::text(*version, step_flags.string() + ": compiler_version") : "unknown";
}

/// The version, with the git commit if the project is a git checkout.
std::string describe_version(const fs::path& project) {
  if (!fs::exists(project / ".git")) return ATELIER_VERSION;
  try {
    const Finished git = run_process({.arguments = {"git", "-C", project.string(), "describe", "--always", "--dirty"},
                                      .time_limit = std::chrono::seconds(5)});
    if (git.ok()) return fmt::format("{} ({})", ATELIER_VERSION, first_line(git.output));
  } catch (const Error&) {
    // git is not installed.
  }
  return ATELIER_VERSION;
}

std::string gl_string(Gl& gl, GLenum name) {
  const auto* text = reinterpret_cast<const char*>(gl.GetString(name));
  return text ? printable(text) : "unknown";
}

/// Removes the variables that affect a driver from this process's environment, as for a step program, and restores them
/// at the end of the scope. So the driver described is the one that draws.
class DefaultDriverEnvironment {
 public:
  DefaultDriverEnvironment() {
    removed_ = own_environment();
    std::erase_if(removed_, [](const auto& variable) { return !judge::affects_driver(variable.first); });
    for (const auto& [name, value] : removed_) ::unsetenv(name.c_str());
  }
  ~DefaultDriverEnvironment() {
    for (const auto& [name, value] : removed_) ::setenv(name.c_str(), value.c_str(), 1);
  }
  DefaultDriverEnvironment(const DefaultDriverEnvironment&) = delete;
  DefaultDriverEnvironment& operator=(const DefaultDriverEnvironment&) = delete;

 private:
  std::map<std::string, std::string> removed_;
};

struct Drawing {
  std::string context, driver;
};

Drawing describe_drawing(const std::string& context) {
  const DefaultDriverEnvironment restored_later;
  try {
    const auto made = context.empty() ? make_headless_context() : make_headless_context(parse_context_kind(context));
    return {to_string(made->kind()),
            fmt::format("OpenGL {}, {}", gl_string(made->gl(), GL_VERSION), gl_string(made->gl(), GL_RENDERER))};
  } catch (const Error& error) {
    return {context, std::string(no_driver) + error.what()};
  }
}

}  // namespace

std::string describe_driver(const std::string& context) {
  return describe_drawing(context).driver;
}

judge::Environment describe_environment(const std::string& context, const fs::path& step_flags,
                                        const fs::path& project) {
  const Drawing drawing = describe_drawing(context);
  return {{"driver", drawing.driver}, {"context", drawing.context},  {"compiler", describe_compiler(step_flags)},
          {"cpu", describe_cpu()},    {"system", describe_system()}, {"atelier", describe_version(project)}};
}

}  // namespace atelier::grade
