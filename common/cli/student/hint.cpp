// ./atelier hint: shows the next of a case's three hints.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/student/hints.hpp"
#include "judge/report/report_terminal.hpp"

namespace atelier {

int run_hint(const HintOptions& options) {
  const ProjectFolders folders = project_folders();
  const auto course = read_course(folders.step_flags());
  const CourseStep& step = resolve_step(course, options.step);
  const int width = std::min(100, judge::terminal_style(STDOUT_FILENO).width);
  if (options.level) {
    const ProgressRecord record = read_progress(folders.progress());
    fmt::print("{}", hint_text(hint_at(folders, step, options.case_name, record, *options.level), width));
    return exit_ok;
  }
  Hint hint;
  change_progress(folders.progress(),
                  [&](ProgressRecord& record) { hint = next_hint(folders, step, options.case_name, record); });
  fmt::print("{}", hint_text(hint, width));
  return exit_ok;
}

}  // namespace atelier
