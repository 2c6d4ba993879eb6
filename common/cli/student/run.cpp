// ./atelier run: runs a step's program with the student's files.
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/student/own_files.hpp"

namespace atelier {
namespace {

/// Says in one line whose files are used: "03-shadow-mapping: yours (steps/03-shadow-mapping); 01-transforms:
/// solution". The step's own files are always the student's.
std::string whose_files(const ProjectFolders& folders, const CourseStep& step, const Owners& earlier) {
  std::string line = fmt::format("{}: {} ({})", step.name, to_string(Owner::mine),
                                 (folders.steps() / step.name).lexically_relative(folders.own()).string());
  for (const auto& [name, owner] : earlier) line += fmt::format("; {}: {}", name, to_string(owner));
  return line;
}

}  // namespace

int run_run(const RunOptions& options) {
  if (options.step.empty()) throw Error("run: say which step, as in ./atelier run 02");
  const ProjectFolders folders = project_folders();
  const auto course = read_course(folders.step_flags());
  const CourseStep step = resolve_step(course, options.step);
  const OwnFiles own = prepare_own_files(folders, course, step, code_of(folders, Owner::mine), options.earlier);
  if (!own.built.ok) throw Error(fmt::format("{} does not build:\n{}", step.name, own.built.log));
  if (!own.built.log.empty()) fmt::print(stderr, "{}", own.built.log);  // warnings
  fmt::print(stderr, "{}\n", whose_files(folders, step, own.earlier));

  std::vector<std::string> arguments = {folders.program(step.name).string(), "--implementations", own.path.to_string()};
  arguments.insert(arguments.end(), options.arguments.begin(), options.arguments.end());
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  std::fflush(stdout);
  ::signal(SIGPIPE, SIG_DFL);  // ignored signals would be inherited
  ::execv(pointers[0], pointers.data());
  throw Error(fmt::format("{}: cannot be started: {}; build the project again", arguments[0], std::strerror(errno)));
}

}  // namespace atelier
