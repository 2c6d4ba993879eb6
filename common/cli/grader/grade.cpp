// ./atelier grade: judges a submission step by step and writes the result files.
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <deque>
#include <exception>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/file_url.hpp"
#include "base/printable.hpp"
#include "base/replace_together.hpp"
#include "cli/commands.hpp"
#include "cli/criteria.hpp"
#include "cli/layout.hpp"
#include "cli/progress.hpp"
#include "cli/search_path.hpp"
#include "cli/stop.hpp"
#include "grade/environment.hpp"
#include "grade/submission.hpp"
#include "judge/report/report_html.hpp"
#include "judge/report/report_json.hpp"
#include "judge/report/report_junit.hpp"
#include "judge/report/report_terminal.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using judge::StepResult;

/// Data shared by all steps of one submission.
struct Grading {
  ProjectFolders folders = project_folders();
  std::vector<CourseStep> course = read_course(folders.step_flags());
  judge::StepFlags flags = judge::read_step_flags(folders.step_flags());
  TemporaryFolder work_folder{"atelier-grade"};  ///< the copied files, their libraries, the driver's cache
  grade::Submission submission;
  std::uint64_t seed = 0;  ///< of the numbers that are drawn for it
};

/// Creates the results folder before grading, so that a long run does not fail at the end.
void prepare_results_folder(const fs::path& out) {
  std::error_code error;
  fs::create_directories(out, error);
  if (error || ::access(out.c_str(), W_OK) != 0)
    throw Error(fmt::format("--out {}: results cannot be written there ({}); name a writable folder", out.string(),
                            error ? error.message() : std::strerror(errno)));
}

/// Sets the commands that judge a case of this submission again; empty for an archive, which `check` cannot read. With
/// drawn numbers only `grade` does.
void set_rerun_commands(judge::SubmissionResult& result, const Grading& grading, const fs::path& handed_in) {
  const fs::path& source = grading.submission.source;
  const std::string folder = source.empty() ? "" : shell_word(source.string());
  for (StepResult& step : result.steps)
    for (judge::CaseResult& c : step.cases)
      if (!c.other_numbers.empty())
        c.command = fmt::format("./atelier grade {} --step {} --seed {}", shell_word(handed_in.string()), step.step,
                                grading.seed);
      else
        c.command =
            folder.empty() ? "" : fmt::format("./atelier check {} --case {} --sources {}", step.step, c.name, folder);
}

/// The requested steps, or all that were handed in.
std::vector<CourseStep> steps_to_grade(const Grading& grading, const std::vector<std::string>& asked) {
  std::vector<CourseStep> steps = resolve_steps(grading.course, asked);
  if (asked.empty())
    std::erase_if(steps, [&](const auto& step) { return !grading.submission.present.contains(step.name); });
  return steps;
}

/// Earlier steps come from the solution, which a release may lack.
void require_earlier_solutions(const ProjectFolders& folders, const std::vector<CourseStep>& steps) {
  for (const CourseStep& step : steps)
    for (const std::string& earlier : step.uses)
      if (!is_there(folders, earlier, Owner::solution))
        throw Error(
            fmt::format("grade: {} is graded with the solution of {}, and this copy of the course has none "
                        "that runs here",
                        step.name, earlier));
}

StepResult grade_step(const Grading& grading, const GradeOptions& options, const CourseStep& step,
                      const grade::StepJudge& judge, const StopOnSignal& stop, Progress& progress) {
  const grade::Submission& submission = grading.submission;
  if (const auto found = submission.skipped.find(step.name); found != submission.skipped.end())
    return judge.judge_absent(fmt::format("The folder {} {}.", step.name, found->second));
  if (!submission.present.contains(step.name)) return judge.judge_absent();
  if (const auto found = submission.unusable.find(step.name); found != submission.unusable.end())
    return judge.judge_unbuilt(judge::not_built(found->second));

  const grade::Code code{.sources = submission.folder, .libraries = grading.work_folder.path() / "libraries"};
  progress.building(step.name);
  const judge::Built built = judge::build_step(grading.flags, step.name, code.sources / step.name, code.libraries);
  if (stop.requested()) throw judge::Interrupted();  // do not blame the student for an interrupted compiler
  if (!built.ok) return judge.judge_unbuilt(built);

  const Owners earlier = choose_owners(grading.folders, grading.course, step, "solution");
  judge::RunSettings settings;
  settings.program = grading.folders.program(step.name);
  settings.implementations = search_path(grading.folders, step, code, earlier);
  if (is_there(grading.folders, step.name, Owner::solution))
    settings.solution = search_path(grading.folders, step, code_of(grading.folders, Owner::solution), earlier);
  settings.context = options.context;
  settings.workers = options.workers;
  settings.shuffle = options.shuffle;
  settings.interrupted = [&] { return stop.requested(); };
  settings.shader_cache = grading.work_folder.path() / "shaders";  // never shared, since it contains machine code
  std::optional<grade::VariedCases> varied;
  if (settings.solution) {
    judge::RunSettings solution = settings;
    solution.implementations = *settings.solution;
    solution.workers = 1;  // starting another program takes longer than the few cases
    solution.shader_cache = grading.work_folder.path() / "shaders of the solution";
    varied = judge.vary(grading.seed, solution);
  }
  std::size_t judged = 0;
  const auto on_case = [&] { progress.judged(step.name, ++judged, judge.cases().size()); };
  StepResult result = judge.judge(settings, judge::KeepEvidence::failures, on_case, varied ? &*varied : nullptr);
  result.build_log = built.log;
  result.implementations = in_words(earlier, step.name, "submission");
  return result;
}

void write_results(judge::SubmissionResult& result, const fs::path& out) {
  for (StepResult& step : result.steps)
    for (judge::CaseResult& c : step.cases) judge::draw_flip(c);
  replace_together({{out / "results.json", [&](const fs::path& file) { judge::write_results_json(file, result); }},
                    {out / "junit.xml", [&](const fs::path& file) { judge::write_junit_xml(file, result); }},
                    {out / "report.html", [&](const fs::path& file) { judge::write_html_report(file, result); }}});
}

}  // namespace

int run_grade(const GradeOptions& options) {
  const StopOnSignal stop;
  Grading grading;
  grading.submission =
      grade::take_submission(grading.flags, options.submission, grading.work_folder.path() / "submission");
  grading.seed = options.seed.value_or(grade::seed_of(grading.submission));
  const fs::path out =
      options.out.empty() ? grading.folders.out() / "grade" / grading.submission.name : fs::absolute(options.out);

  const std::vector<CourseStep> steps = steps_to_grade(grading, options.steps);
  const judge::Environment environment =
      grade::describe_environment(options.context, grading.folders.step_flags(), grading.folders.root);
  if (const std::string& driver = environment.at("driver"); driver.starts_with(grade::no_driver))
    throw Error(
        fmt::format("this machine cannot draw, so nothing is graded: {}", driver.substr(grade::no_driver.size())));
  require_earlier_solutions(grading.folders, steps);
  prepare_results_folder(out);

  // Read all references first: if one is broken, nothing is graded.
  std::deque<grade::StepJudge> judges;
  for (const CourseStep& step : steps) {
    judges.emplace_back(criteria_of(grading.folders, step));
    judges.back().require_references();
  }

  judge::SubmissionResult result;
  result.submission = grading.submission.name;
  result.environment = environment;
  Progress progress(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i)
    progress.finished(result.steps.emplace_back(grade_step(grading, options, steps[i], judges[i], stop, progress)));
  progress.clear();
  grade::sum_up(result);
  set_rerun_commands(result, grading, options.submission);
  result.notes = grading.submission.notes;
  for (const CourseStep& step : steps)
    if (is_there(grading.folders, step.name, Owner::solution))
      result.seed = grading.seed;
    else
      result.notes.push_back(step.name + " is judged with the stored numbers alone: its solution is not here");

  // Write the files before printing, since stdout may be closed; but print the verdict even if writing fails.
  std::exception_ptr not_written;
  try {
    write_results(result, out);
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
