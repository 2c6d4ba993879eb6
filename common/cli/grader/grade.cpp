// ./atelier grade: judges a submission step by step and writes the result files.
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/file_url.hpp"
#include "base/printable.hpp"
#include "cli/commands.hpp"
#include "cli/grader/grade_class.hpp"
#include "cli/grader/result_files.hpp"
#include "cli/grader/submission_grader.hpp"
#include "cli/layout.hpp"
#include "cli/progress.hpp"
#include "cli/stop.hpp"
#include "grade/intake/class_folder.hpp"
#include "grade/intake/submission.hpp"
#include "judge/report/report_json.hpp"
#include "judge/report/report_terminal.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using judge::StepResult;

/// Creates the results folder before grading, so that a long run does not fail at the end.
void prepare_results_folder(const fs::path& out) {
  std::error_code error;
  fs::create_directories(out, error);
  if (error || ::access(out.c_str(), W_OK) != 0)
    throw Error(fmt::format("--out {}: results cannot be written there ({}); name a writable folder", out.string(),
                            error ? error.message() : std::strerror(errno)));
}

/// Sets the commands that judge a case of this submission again; empty for an archive, which `check` cannot read.
/// With drawn numbers only `grade` does.
void set_rerun_commands(judge::SubmissionResult& result, const fs::path& source, const fs::path& handed_in) {
  const std::string folder = source.empty() ? "" : shell_word(source.string());
  for (StepResult& step : result.steps)
    for (judge::CaseResult& c : step.cases)
      if (!c.other_numbers.empty())
        c.command = fmt::format("./atelier grade {} --step {} --seed {}", shell_word(handed_in.string()), step.step,
                                result.seed.value_or(0));
      else if (!folder.empty())
        c.command = fmt::format("./atelier check {} --case {} --sources {}", step.step, c.name, folder);
}

/// The requested steps, or all that were handed in.
std::vector<CourseStep> steps_to_grade(const std::vector<CourseStep>& course, const grade::Submission& submission,
                                       const std::vector<std::string>& asked) {
  std::vector<CourseStep> steps = resolve_steps(course, asked);
  if (asked.empty()) std::erase_if(steps, [&](const auto& step) { return !submission.present.contains(step.name); });
  return steps;
}

/// Options that only a class has.
void refuse_options_of_classes(const GradeOptions& options) {
  const auto refuse = [](const char* option) {
    throw Error(fmt::format("{}: is for a class, and this is one submission", option));
  };
  if (options.engine != "local" || !options.engine_arguments.empty()) refuse("--engine");
}

}  // namespace

int run_grade(const GradeOptions& options) {
  if (!options.course.empty() ||
      grade::is_class(judge::read_step_flags(project_folders().step_flags()), options.submissions))
    return run_grade_class(options);
  refuse_options_of_classes(options);
  const StopOnSignal stop;
  const fs::path& source = options.submissions.front();
  const ProjectFolders folders = project_folders();
  const std::vector<CourseStep> course = read_course(folders.step_flags());
  const TemporaryFolder copies("atelier-submission");
  const fs::path skeletons = is_release() ? folders.skeletons() : folders.root / "steps";
  const grade::Submission submission =
      grade::take_submission(judge::read_step_flags(folders.step_flags()), source, copies.path() / "files", skeletons);
  const fs::path out = options.out.empty() ? folders.out() / "grade" / submission.name : fs::absolute(options.out);

  const sandbox::Tier tier = sandbox::choose_tier(sandbox::find_possible_tiers(), options.sandbox);
  const std::vector<CourseStep> steps = steps_to_grade(course, submission, options.steps);
  const SubmissionGrader grader(folders, course, steps,
                                {.context = options.context,
                                 .workers = options.workers > 0 ? std::min(options.workers, 64) : 2,
                                 .shuffle = options.shuffle,
                                 .tier = tier,
                                 .more_cases = options.cases,
                                 .case_limit = {}});
  prepare_results_folder(out);

  Progress progress(steps.size());
  judge::SubmissionResult result = grader.grade(
      submission, options.seed.value_or(grade::seed_of(submission)),
      {.interrupted = [&] { return stop.requested(); },
       .building = [&](const std::string& step) { progress.building(step); },
       .judged = [&](const std::string& step, std::size_t k, std::size_t n) { progress.judged(step, k, n); },
       .finished = [&](const StepResult& step) { progress.finished(step); }});
  progress.clear();
  if (options.cases.empty()) set_rerun_commands(result, submission.source, source);

  // Write the files before printing, since stdout may be closed; but print the verdict even if writing fails.
  std::exception_ptr not_written;
  try {
    write_result_files(result, out);
  } catch (const std::exception&) {
    not_written = std::current_exception();
  }
  judge::TerminalStyle style = judge::terminal_style(STDOUT_FILENO);
  if (judge::can_link(STDOUT_FILENO)) style.report_url = file_url(out / "report.html");
  fmt::print("{}", options.json ? judge::results_json(result) : judge::terminal_report(result, style));
  if (not_written) std::rethrow_exception(not_written);
  if (!options.json) fmt::print("Results: {}\n", judge::report_link(out.string(), result, style));
  return exit_ok;
}

}  // namespace atelier
