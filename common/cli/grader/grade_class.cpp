#include "cli/grader/grade_class.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/folder_lock.hpp"
#include "base/parallel.hpp"
#include "base/printable.hpp"
#include "base/sha256.hpp"
#include "base/stopwatch.hpp"
#include "base/system_reason.hpp"
#include "cli/criteria.hpp"
#include "cli/grader/class_plan.hpp"
#include "cli/grader/class_progress.hpp"
#include "cli/grader/class_worker.hpp"
#include "cli/grader/engine.hpp"
#include "cli/grader/temporary_place.hpp"
#include "cli/layout.hpp"
#include "cli/stop.hpp"
#include "grade/environment.hpp"
#include "grade/results/class_results.hpp"
#include "judge/run/build_record.hpp"
#include "sandbox/control_group.hpp"
#include "sandbox/tier.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

/// The files below a folder, sorted.
std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code missing;
  for (const auto& entry : fs::recursive_directory_iterator(folder, missing))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

/// Changes whenever anything does that a step is judged with: cases and references, known mistakes, solution, program.
std::string hash_of_criteria(const ProjectFolders& folders, const CourseStep& step, const fs::path& more_cases) {
  std::vector<fs::path> files = {folders.mistakes_file(step.name), folders.program(step.name),
                                 folders.build / "lib" / "libatelier.so",
                                 folders.build / "lib" / ("libprogram-" + step.name + ".so")};
  std::vector<std::string> used = step.uses;
  used.push_back(step.name);
  std::vector<fs::path> below = {folders.cases() / step.name, folders.steps() / step.name / "given"};
  if (!more_cases.empty()) below.push_back(more_cases / step.name);
  for (const std::string& name : used) below.push_back(folders.solutions() / name);
  for (const fs::path& folder : below) {
    const std::vector<fs::path> more = files_below(folder);
    files.insert(files.end(), more.begin(), more.end());
  }
  std::string text;
  for (const fs::path& file : files) text += file.filename().string() + ' ' + judge::fingerprint(file) + '\n';
  return sha256(text);
}

/// Which steps a class is graded for: those asked for, or those that course.toml lists, or all.
std::vector<CourseStep> steps_of(const std::vector<CourseStep>& course, const GradeOptions& options,
                                 const grade::CourseFile& rules) {
  std::vector<CourseStep> steps = resolve_steps(course, options.steps);
  if (options.steps.empty()) std::erase_if(steps, [&](const CourseStep& step) { return !rules.counts(step.name); });
  return steps;
}

std::string name_of_class(const GradeOptions& options) {
  const std::string name = fs::weakly_canonical(options.submissions.front()).filename().string();
  return name.empty() ? "class" : printable(name);
}

ClassPlan make_plan(const GradeOptions& options, const ClassPlaces& places, const ProjectFolders& folders,
                    const std::vector<CourseStep>& steps, const grade::CourseFile& rules) {
  ClassPlan plan{.name = name_of_class(options),
                 .folder = grade::find_submissions(judge::read_step_flags(folders.step_flags()), options.submissions,
                                                   places.unpacked(), {.pattern = rules.naming}),
                 .steps = {},
                 .course_file = options.course.empty() ? fs::path() : fs::absolute(options.course),
                 .cases = options.cases.empty() ? fs::path() : fs::absolute(options.cases),
                 .context = options.context,
                 .sandbox = sandbox::to_string(sandbox::choose_tier(sandbox::find_possible_tiers(), options.sandbox)),
                 .seed = options.seed,
                 .shuffle = options.shuffle,
                 .criteria = {}};
  for (const CourseStep& step : steps) {
    plan.steps.push_back(step.name);
    plan.criteria[step.name] = hash_of_criteria(folders, step, plan.cases);
  }
  for (grade::HandedIn& handed_in : plan.folder.submissions)
    for (fs::path& source : handed_in.sources) source = fs::absolute(source);
  return plan;
}

/// The results of two classes must not lie in one folder.
void refuse_other_class(const ClassPlaces& places, const std::string& name) {
  if (!fs::exists(places.plan())) return;
  std::string there;
  try {
    there = read_plan(places).name;
  } catch (const Error&) {
    return;  // of another version
  }
  if (there != name)
    throw Error(
        fmt::format("--out {}: has the results of the class '{}', and this one is '{}'; name another folder, or "
                    "remove {} if it is the same class",
                    places.out.string(), there, name, places.plan().string()));
}

grade::ClassSummary summary_of(const ClassPlan& plan, const ProjectFolders& folders,
                               const std::vector<CourseStep>& steps, double seconds) {
  grade::ClassSummary summary{
      .name = plan.name,
      .platform = plan.folder.platform,
      .ignored = plan.folder.ignored,
      .environment = grade::describe_environment(plan.context, folders.step_flags(), folders.root),
      .seconds = seconds,
      .steps = {}};
  summary.environment["sandbox"] = plan.sandbox;
  for (const CourseStep& step : steps) {
    grade::StepSummary of_step{.step = step.name, .title = step.title, .mistakes = {}};
    if (const fs::path file = folders.mistakes_file(step.name); fs::exists(file))
      of_step.mistakes = judge::read_mistakes(file, judge::Patches::optional);
    summary.steps.push_back(std::move(of_step));
  }
  return summary;
}

std::vector<grade::SubmissionRecord> read_records(const ClassPlaces& places, const ClassPlan& plan) {
  std::vector<grade::SubmissionRecord> records;
  for (const grade::HandedIn& handed_in : plan.folder.submissions)
    records.push_back(grade::read_record(places.record(handed_in.student.id)));
  return records;
}

/// Whether a record is of an earlier run: its reports are older than the plan.
bool is_kept(const ClassPlaces& places, const grade::SubmissionRecord& record) {
  std::error_code missing;
  const fs::file_time_type written = fs::last_write_time(places.student(record.student.id) / "results.json", missing);
  return !missing && written < fs::last_write_time(places.plan());
}

void print_summary(const ClassPlaces& places, const grade::ClassResults& results) {
  const auto need_human =
      std::ranges::count_if(results.rows, [](const auto& row) { return !row.grade.needs_human.empty(); });
  const auto kept = std::ranges::count_if(results.rows, [&](const auto& row) { return is_kept(places, row.record); });
  fmt::print("{} submissions: {} graded in {}, {} kept from before\n", results.rows.size(),
             std::ptrdiff_t(results.rows.size()) - kept, duration_words(results.summary.seconds), kept);
  if (const std::size_t ignored = results.summary.ignored.size(); ignored > 0)
    fmt::print("{} {} no submission: see the end of class.html\n", ignored, ignored == 1 ? "entry is" : "entries are");
  if (need_human > 0)
    fmt::print("{} need{} a person: see {}\n", need_human, need_human == 1 ? "s" : "",
               (places.out / "class.html").string());
  fmt::print("Gradebook: {}\n", (places.out / "gradebook.csv").string());
}

}  // namespace

int run_grade_class(const GradeOptions& options) {
  const StopOnSignal stop;
  const Stopwatch watch;
  if (options.engine == "slurm") require_slurm();
  const ProjectFolders folders = project_folders();
  const std::vector<CourseStep> course = read_course(folders.step_flags());
  const grade::CourseFile rules = read_rules(options.course, course);
  const std::vector<CourseStep> steps = steps_of(course, options, rules);
  const ClassPlaces places{options.out.empty() ? folders.out() / "grade" / name_of_class(options)
                                               : fs::absolute(options.out)};
  std::error_code error;
  fs::create_directories(places.state(), error);
  if (error || ::access(places.state().c_str(), W_OK) != 0)
    throw Error(fmt::format("--out {}: results cannot be written there ({}); name a writable folder",
                            places.out.string(), error ? error.message() : system_reason()));
  const std::optional<FolderLock> lock = FolderLock::try_lock(places.state());
  if (!lock) throw Error(fmt::format("--out {}: another process grades into this folder", places.out.string()));
  for (const fs::path& folder : {places.out, places.state()}) remove_unfinished_files(folder);
  const TemporaryPlace temporary(places.temporary());
  sandbox::ControlGroup::remove_abandoned();
  refuse_other_class(places, name_of_class(options));
  fs::remove_all(places.unpacked());
  const ClassPlan plan = make_plan(options, places, folders, steps, rules);
  write_plan(places, plan);

  {
    ClassProgress progress(places, plan);
    const EngineSettings settings{.places = places,
                                  .temporary = temporary,
                                  .workers = options.workers > 0 ? options.workers : worker_threads(),
                                  .arguments = options.engine_arguments,
                                  .interrupted = [&] { return stop.requested(); },
                                  .waiting = [&] { progress.show(); }};
    try {
      options.engine == "slurm" ? run_slurm_engine(settings, plan) : run_local_engine(settings, plan);
    } catch (const judge::Interrupted&) {
      progress.stopped();
      throw;
    }
  }
  const std::vector<grade::SubmissionRecord> records = read_records(places, plan);
  const grade::ClassSummary summary = summary_of(plan, folders, steps, watch.seconds());
  grade::write_class_results(places.out, rules, summary, records);
  print_summary(places, grade::class_results(places.out, rules, summary, records));
  return exit_ok;
}

}  // namespace atelier
