#include "cli/grader/submission_grader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "cli/criteria.hpp"
#include "cli/grader/solution_for_later_steps.hpp"
#include "cli/search_path.hpp"
#include "grade/environment.hpp"
#include "judge/run/build.hpp"
#include "sandbox/control_group.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using judge::StepResult;

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

/// Two programs at a time share the usual limits; more get as much each.
sandbox::Limits limits_of(int workers) {
  sandbox::Limits limits;
  const int pairs = std::max(1, (workers + 1) / 2);
  limits.memory *= std::size_t(pairs);
  limits.processes *= pairs;
  return limits;
}

/// The solution's run beside a student's: trusted.
judge::RunSettings as_solution(judge::RunSettings settings) {
  settings.implementations = *settings.solution;
  settings.sandbox = nullptr;
  settings.workers = 1;  // starting another program takes longer than the few cases
  return settings;
}

}  // namespace

SubmissionGrader::SubmissionGrader(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                                   const std::vector<CourseStep>& steps, const GraderSettings& settings)
    : folders_(folders),
      course_(course),
      steps_(steps),
      flags_(judge::read_step_flags(folders.step_flags())),
      settings_(settings),
      environment_(grade::describe_environment(settings.context, folders.step_flags(), folders.root)),
      solution_shaders_("atelier-shaders"),
      published_("atelier-published") {
  if (const std::string& driver = environment_.at("driver"); driver.starts_with(grade::no_driver))
    throw Error(
        fmt::format("this machine cannot draw, so nothing is graded: {}", driver.substr(grade::no_driver.size())));
  environment_["sandbox"] = sandbox::to_string(settings.tier);
  require_earlier_solutions(folders, steps);
  sandbox::ControlGroup::remove_abandoned();
  for (const CourseStep& step : steps) {
    judges_.emplace_back(criteria_of(folders, step));
    judges_.back().require_references();
  }
  publish_earlier_steps();
  if (!settings_.more_cases.empty()) add_more_cases();
}

void SubmissionGrader::add_more_cases() {
  const auto file_of = [&](const CourseStep& step) { return settings_.more_cases / step.name / "cases.json"; };
  if (std::ranges::none_of(course_, [&](const CourseStep& step) { return fs::exists(file_of(step)); }))
    throw Error(fmt::format("--cases {}: has no cases; they are in NN-name/cases.json, such as {}",
                            settings_.more_cases.string(), file_of(course_.front()).string()));
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (!fs::exists(file_of(steps_[i]))) continue;
    if (!is_there(folders_, steps_[i].name, Owner::solution))
      throw Error(fmt::format("--cases: the solution of {} must answer them, and is not here", steps_[i].name));
    judges_[i].add_cases(file_of(steps_[i]), as_solution(run_settings({}, steps_[i])));
  }
}

void SubmissionGrader::publish_earlier_steps() {
  std::set<std::string> used;
  for (const CourseStep& step : steps_) used.insert(step.uses.begin(), step.uses.end());
  for (const std::string& name : used)
    for (const auto& [file, bytes] : solution_for_later_steps(folders_, resolve_step(course_, name)))
      write_file(published_.path() / name / file, bytes);
  fs::permissions(published_.path(), fs::perms(0755));
}

/// What a student's program may read: given code, its own, and what is published of the steps that it uses.
Implementations SubmissionGrader::public_search_path(const CourseStep& step, const grade::Code& code) const {
  std::vector<Implementations::Root> roots = {{folders_.steps(), step.name + "/given"}};
  for (const fs::path& folder : {code.libraries, code.sources})
    if (!folder.empty() && fs::is_directory(folder / step.name)) roots.push_back({folder, step.name});
  for (const std::string& name : step.uses) {
    roots.push_back({published_.path(), name});
    if (fs::is_directory(folders_.steps() / name / "given")) roots.push_back({folders_.steps(), name + "/given"});
  }
  return Implementations(std::move(roots));
}

judge::SubmissionResult SubmissionGrader::grade(const grade::Submission& submission, std::uint64_t seed,
                                                const GraderEvents& events) const {
  judge::SubmissionResult result;
  result.submission = submission.name;
  result.environment = environment_;
  result.notes = submission.notes;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (is_there(folders_, steps_[i].name, Owner::solution))
      result.seed = seed;
    else
      result.notes.push_back(steps_[i].name + " is judged with the stored numbers alone: its solution is not here");
    result.steps.push_back(grade_step(submission, steps_[i], judges_[i], seed, events));
    if (events.finished) events.finished(result.steps.back());
  }
  grade::sum_up(result);
  return result;
}

StepResult SubmissionGrader::grade_step(const grade::Submission& submission, const CourseStep& step,
                                        const grade::StepJudge& judge, std::uint64_t seed,
                                        const GraderEvents& events) const {
  if (const auto found = submission.skipped.find(step.name); found != submission.skipped.end())
    return judge.judge_absent(fmt::format("The folder {} {}.", step.name, found->second));
  if (!submission.present.contains(step.name)) return judge.judge_absent();
  if (submission.untouched.contains(step.name))
    return judge.judge_absent("The skeleton was handed in as it was given, so nothing is judged.",
                              "Hand in the files that you have changed.");
  if (const auto found = submission.unusable.find(step.name); found != submission.unusable.end())
    return judge.judge_unbuilt(judge::not_built(found->second));

  const TemporaryFolder work("atelier-grade");  // the student's libraries
  const sandbox::Sandbox sandbox(settings_.tier, limits_of(settings_.workers));
  sandbox.let_through(work.path());
  sandbox.let_through(submission.folder.parent_path());
  const grade::Code code{.sources = submission.folder, .libraries = work.path() / "libraries"};
  if (events.building) events.building(step.name);
  const Stopwatch compiling;
  const judge::Built built =
      judge::build_step(flags_, step.name, code.sources / step.name, code.libraries, {.sandbox = &sandbox});
  const double seconds = compiling.seconds();
  if (events.interrupted && events.interrupted())
    throw judge::Interrupted();  // do not blame the student for an interrupted compiler
  judge::RunSettings settings = run_settings(code, step);
  settings.sandbox = &sandbox;
  settings.interrupted = events.interrupted;
  StepResult result = built.ok ? grade_built(step, judge, settings, seed, events) : judge.judge_unbuilt(built);
  result.build_log = built.log;
  result.seconds["compile"] = seconds;
  return result;
}

judge::RunSettings SubmissionGrader::run_settings(const grade::Code& code, const CourseStep& step) const {
  judge::RunSettings settings;
  settings.program = folders_.program(step.name);
  settings.implementations = public_search_path(step, code);
  if (is_there(folders_, step.name, Owner::solution))
    settings.solution = search_path(folders_, step, code_of(folders_, Owner::solution),
                                    choose_owners(folders_, course_, step, "solution"));
  settings.context = settings_.context;
  settings.workers = settings_.workers;
  settings.shuffle = settings_.shuffle;
  if (settings_.case_limit) settings.case_limit = *settings_.case_limit;
  settings.shader_cache = solution_shaders_.path();  // a program in a sandbox has none
  settings.readable = {folders_.root / "common"};    // shaders
  return settings;
}

StepResult SubmissionGrader::grade_built(const CourseStep& step, const grade::StepJudge& judge,
                                         const judge::RunSettings& settings, std::uint64_t seed,
                                         const GraderEvents& events) const {
  const Stopwatch drawing;
  std::optional<grade::VariedCases> varied;
  if (settings.solution) {
    varied = judge.vary(seed, as_solution(settings));
  }
  const double seconds = drawing.seconds();
  std::size_t judged = 0;
  const auto on_case = [&] {
    if (events.judged) events.judged(step.name, ++judged, judge.cases().size());
  };
  StepResult result = judge.judge(settings, judge::KeepEvidence::failures, on_case, varied ? &*varied : nullptr);
  result.implementations = in_words(choose_owners(folders_, course_, step, "solution"), step.name, "submission");
  result.seconds["solution"] = seconds;
  return result;
}

}  // namespace atelier
