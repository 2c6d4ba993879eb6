// ./atelier reset: resets a student's file to its skeleton.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/student/reset_file.hpp"

namespace atelier {
namespace {

/// Asks the student for confirmation. Throws Error without a terminal.
bool confirmed(const std::string& file) {
  if (::isatty(STDIN_FILENO) != 1)
    throw Error(fmt::format("reset {}: there is no terminal to ask on; --force resets without asking", file));
  fmt::print("Reset steps/{} to its skeleton? A copy of yours is kept. [y/N] ", file);
  std::fflush(stdout);
  std::string answer;
  std::getline(std::cin, answer);
  return answer.starts_with('y') || answer.starts_with('Y');
}

}  // namespace

int run_reset(const ResetOptions& options) {
  const ProjectFolders folders = project_folders();
  const StudentFile file = find_student_file(folders, read_course(folders.step_flags()), options.file);
  const std::string name = file.below_steps().string();
  if (is_pristine(folders, file)) {
    fmt::print("steps/{} is the untouched skeleton; nothing was changed.\n", name);
    return exit_ok;
  }
  if (!options.force && !confirmed(name)) {
    fmt::print("Nothing was changed.\n");
    return exit_failed;
  }
  const Reset reset = reset_file(folders, file);
  if (reset.copy.empty())
    fmt::print("steps/{} is the skeleton again.\n", name);
  else
    fmt::print("steps/{} is the skeleton again; yours is kept in {}\n", name,
               reset.copy.lexically_relative(folders.own()).string());
  return exit_ok;
}

}  // namespace atelier
