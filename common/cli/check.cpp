// ./atelier check: a student's own files of one step, from the last edit to a verdict.
//
// Somebody waits for this at every save, so the order is: build and read references at the same time, draw, judge,
// print the verdict, and only then whatever is slow (the environment, the pictures of the report).
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <future>

#include "base/error.hpp"
#include "cli/after_pass.hpp"
#include "cli/commands.hpp"
#include "cli/layout.hpp"
#include "cli/own_files.hpp"
#include "cli/standing.hpp"
#include "grade/environment.hpp"
#include "judge/preview.hpp"
#include "judge/report_html.hpp"
#include "judge/report_json.hpp"
#include "judge/report_terminal.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using judge::StepResult;

judge::RunSettings run_settings(const ProjectFolders& folders, const CheckOptions& options, const std::string& step,
                                const Implementations& path) {
  judge::RunSettings settings;
  settings.program = folders.program(step);
  settings.implementations = path;
  settings.context = options.context;
  settings.shader_cache = folders.shader_cache();
  return settings;
}

/// The files in steps/, or those in a folder of the caller's, whose libraries are kept apart.
grade::Code own_code(const ProjectFolders& folders, const CheckOptions& options) {
  if (options.sources.empty()) return code_of(folders, Owner::mine);
  return {.sources = fs::absolute(options.sources), .libraries = folders.implementations() / "elsewhere"};
}

StepResult judge_own_files(const ProjectFolders& folders, const CheckOptions& options, const CourseStep& step,
                           const std::vector<CourseStep>& course) {
  const grade::StepJudge judge({.cases = folders.case_file(step.name),
                                .mistakes = folders.mistakes_file(step.name),
                                .reference_cache = folders.reference_cache()},
                               options.cases);
  std::future<void> references = std::async(std::launch::async, [&] { judge.require_references(); });
  const OwnFiles own = prepare_own_files(folders, course, step, own_code(folders, options), options.earlier);
  references.get();

  StepResult result =
      own.built.ok ? judge.judge(run_settings(folders, options, step.name, own.path), judge::KeepEvidence::always)
                   : judge.judge_unbuilt(own.built);
  if (own.built.not_taken.empty()) result.build_log = own.built.log;
  result.implementations = in_words(own.earlier, step.name, "yours");
  return result;
}

void print_verdict(const StepResult& result, const CheckOptions& options, const fs::path& report) {
  judge::TerminalStyle style = judge::terminal_style(STDOUT_FILENO);
  style.heat_maps = options.heatmap;
  if (!options.skip_report && judge::can_link(STDOUT_FILENO))
    style.report_url = "file://" + (report / "report.html").string();
  fmt::print("{}", judge::terminal_report(result, style));
  std::fflush(stdout);
}

/// The picture that an editor shows: the first one that fails, or the first one.
const judge::Evidence* picture_to_show(const StepResult& result) {
  const judge::Evidence* first = nullptr;
  for (const judge::CaseResult& c : result.cases) {
    if (!c.evidence) continue;
    if (c.status != judge::Status::passed) return &*c.evidence;
    if (first == nullptr) first = &*c.evidence;
  }
  return first;
}

void write_reports(judge::SubmissionResult& result, const fs::path& folder) {
  for (judge::CaseResult& c : result.steps.front().cases)
    if (c.status != judge::Status::passed) judge::draw_flip(c);
  judge::write_results_json(folder / "results.json", result);
  judge::write_html_report(folder / "report.html", result);
  if (const judge::Evidence* evidence = picture_to_show(result.steps.front()))
    judge::write_preview(folder / "preview.png", *evidence);
}

/// Whether this check says how far the student is: of the own files, and of every case.
bool counts_as_progress(const CheckOptions& options) {
  return options.cases.empty() && options.sources.empty();
}

/// Takes the verdict down, unless the files were edited meanwhile: it is then about a text that is nowhere any more.
void record_progress(const ProjectFolders& folders, const CourseStep& step, const StepResult& result,
                     const std::string& files_before) {
  if (digest_of_files(folders.steps() / step.name, step.files) != files_before) return;
  ProgressRecord record = read_progress(folders.progress());
  record_check(record, result, files_before);
  write_progress(folders.progress(), record);
}

}  // namespace

int run_check(const CheckOptions& options) {
  const ProjectFolders folders = project_folders();
  const auto course = read_course(folders.step_flags());
  const CourseStep step = resolve_step(course, options.step);
  const fs::path report = options.report.empty() ? folders.out() / "check" / step.name : fs::absolute(options.report);

  read_progress(folders.progress());  // a broken record is better heard of before the work than after
  const std::string files = digest_of_files(folders.steps() / step.name, step.files);

  judge::SubmissionResult result;
  result.submission = "yours";
  result.steps.push_back(judge_own_files(folders, options, step, course));
  grade::sum_up(result);
  if (!options.json) print_verdict(result.steps.front(), options, report);
  if (counts_as_progress(options)) record_progress(folders, step, result.steps.front(), files);

  if (options.json || !options.skip_report)
    result.environment = grade::describe_environment(options.context, folders.step_flags(), folders.root);
  if (options.json) fmt::print("{}", judge::results_json(result));
  if (!options.skip_report) {
    write_reports(result, report);
    if (!options.json) fmt::print("Report: {}\n", (report / "report.html").string());
  }
  const bool passed = grade::all_passed(result.steps.front());
  if (counts_as_progress(options) && !options.json) {
    const ProgressRecord record = read_progress(folders.progress());
    fmt::print("{}", passed ? after_pass(folders, standings(folders, course, record), step.name)
                            : fmt::format("Stuck? ./atelier hint {}\n", step.number()));
  }
  return passed ? exit_ok : exit_failed;
}

}  // namespace atelier
