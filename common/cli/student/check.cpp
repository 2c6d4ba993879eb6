// ./atelier check: builds and judges a student's files of one step.
//
// For a fast verdict the order is: build and read references in parallel, draw, judge, print the verdict, and only then
// the slow parts (the environment, the report's pictures).
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>

#include "base/error.hpp"
#include "base/file_url.hpp"
#include "cli/commands.hpp"
#include "cli/search_path.hpp"
#include "cli/stop.hpp"
#include "cli/student/after_pass.hpp"
#include "cli/student/own_check.hpp"
#include "cli/student/standing.hpp"
#include "grade/environment.hpp"
#include "judge/report/report_json.hpp"
#include "judge/report/report_terminal.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

judge::TerminalStyle style_of(const CheckOptions& options, const fs::path& page) {
  judge::TerminalStyle style = judge::terminal_style(STDOUT_FILENO);
  style.table = options.table;
  style.heat_maps = options.heatmap;
  if (!options.skip_report && judge::can_link(STDOUT_FILENO)) style.report_url = file_url(page);
  return style;
}

/// A note if a picture may have failed because of the driver, and the solution is here to draw with this one: the
/// stored references were drawn by llvmpipe.
std::string on_another_driver(const judge::SubmissionResult& result, const OwnCheck& check, bool live) {
  const auto driver = result.environment.find("driver");
  if (live || !is_there(check.folders(), check.step().name, Owner::solution) || driver == result.environment.end() ||
      driver->second.find("llvmpipe") != std::string::npos)
    return {};
  return fmt::format(
      "Your driver ({}) is not the one that drew the references: if only edges differ, use --references live to "
      "compare with the solution's pictures on yours.\n",
      driver->second);
}

/// What to do next: after a pass, or to get a hint; nothing where the compiler has said it.
std::string what_next(const OwnCheck& check, const judge::StepResult& result, bool passed) {
  const auto is_unbuilt = [](const judge::CaseResult& c) { return c.status == judge::Status::build_failed; };
  if (std::ranges::any_of(result.cases, is_unbuilt)) return {};
  if (!passed) return fmt::format("Stuck? ./atelier hint {}\n", check.step().number());
  const ProgressRecord record = read_progress(check.folders().progress());
  return after_pass(check.folders(), standings(check.folders(), check.course(), record), check.step().name);
}

/// How to look into a failed picture: the first that the report's causes show, at its worst pixel.
std::string where_to_look(const judge::StepResult& result, const std::string& step) {
  for (const judge::Cause& cause : result.causes)
    for (const auto* indices : {&cause.shown, &cause.waiting})
      for (const std::size_t i : *indices)
        if (const judge::CaseResult& c = result.cases[i]; c.worst)
          return fmt::format("One pixel, step by step: ./atelier explain {} {} --pixel {},{}\n", step, c.name,
                             c.worst->x, c.worst->y);
  return {};
}

}  // namespace

int run_check(const CheckOptions& options) {
  const StopOnSignal stop;
  const ProjectFolders folders = project_folders();
  const auto course = read_course(folders.step_flags());
  OwnCheck check(folders, course, resolve_step(course, options.step),
                 {.cases = options.cases,
                  .context = options.context,
                  .earlier = options.earlier,
                  .sources = options.sources,
                  .live = options.live});
  const fs::path report =
      options.report.empty() ? own_report_folder(folders, check.step().name) : fs::absolute(options.report);
  const fs::path page = report / "report.html";
  const judge::TerminalStyle style = style_of(options, page);

  judge::SubmissionResult result;
  result.submission = "yours";
  result.steps.push_back(check.judge([&] { return stop.requested(); }));
  grade::sum_up(result);
  // Record first, since the output pipe may close; a failure to record must not prevent the verdict.
  std::exception_ptr not_recorded;
  try {
    check.record(result.steps.front());
  } catch (const Error&) {
    not_recorded = std::current_exception();
  }
  if (!options.json) {
    fmt::print("{}", judge::terminal_report(result.steps.front(), style));
    std::fflush(stdout);
  }
  if (not_recorded) std::rethrow_exception(not_recorded);

  if (options.json || !options.skip_report)
    result.environment = grade::describe_environment(options.context, folders.step_flags(), folders.root);
  if (options.json) fmt::print("{}", judge::results_json(result));
  if (!options.skip_report) {
    write_own_report(result, report);
    if (!options.json) fmt::print("Report: {}\n", judge::report_link(page.string(), result, style));
  }
  const bool passed = grade::all_passed(result.steps.front());
  if (!passed && !options.json) fmt::print("{}", on_another_driver(result, check, options.live));
  if (!passed && !options.json && options.sources.empty())
    fmt::print("{}", where_to_look(result.steps.front(), check.step().number()));
  if (check.counts_as_progress() && !options.json) fmt::print("{}", what_next(check, result.steps.front(), passed));
  return passed ? exit_ok : exit_failed;
}

}  // namespace atelier
