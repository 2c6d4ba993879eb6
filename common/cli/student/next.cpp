// ./atelier next: the first step that has not passed in full, and how to start it.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "base/columns.hpp"
#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/student/handout.hpp"
#include "cli/student/standing.hpp"
#include "judge/report/report_terminal.hpp"

namespace atelier {

int run_next(const NextOptions&) {
  const ProjectFolders folders = project_folders();
  const auto all = standings(folders, read_course(folders.step_flags()), read_progress(folders.progress()));
  const int width = std::min(100, judge::terminal_style(STDOUT_FILENO).width);
  const Standing* next = next_step(all);
  if (next == nullptr) {
    fmt::print("Every step has passed in full.\n");
    return exit_ok;
  }
  const CourseStep& step = next->step;
  const std::string number = step.number();
  fmt::print("{}  {}  ({})\n{}\n\n", step.name, step.title, in_words(*next), wrapped(goal_of(folders, step), width, 0));
  if (const std::string reading = handout_of(folders, step); !reading.empty()) fmt::print("  read    {}\n", reading);
  for (const std::string& header : step.headers)
    if (header.starts_with(step.name + "/")) fmt::print("  read    steps/{}: the contract\n", header);
  for (const std::string& file : step.files) fmt::print("  write   steps/{}/{}\n", step.name, file);
  fmt::print("  look    ./atelier run {0}\n  check   ./atelier check {0}\n  stuck?  ./atelier hint {0}\n", number);
  return exit_ok;
}

}  // namespace atelier
