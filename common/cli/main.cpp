// The program behind ./atelier. CLI11 takes six seconds to compile, so only this file includes it.
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "cli/commands.hpp"
#include "cli/grader/class_worker.hpp"
#include "cli/layout.hpp"
#include "cli/student/skeleton_update.hpp"
#include "grade/varied_cases.hpp"

namespace atelier {
namespace {

/// The command line. Parsing it stores the chosen subcommand's call in `action`.
struct Interface {
  CLI::App app{"A course in real-time rendering that grades itself."};
  std::function<int()> action;

  /// Adds a subcommand: its options are read into `options` and passed to `run`.
  template <class Options>
  CLI::App* add(const char* name, const char* text, Options& options, int (*run)(const Options&)) {
    return add_to(app, name, text, options, run);
  }

  /// Adds a command of a command: ./atelier course check.
  template <class Options>
  CLI::App* add_to(CLI::App& parent, const char* name, const char* text, Options& options, int (*run)(const Options&)) {
    CLI::App* command = parent.add_subcommand(name, text);
    command->final_callback([this, &options, run] { action = [&options, run] { return run(options); }; });
    return command;
  }
};

void add_step(CLI::App* command, std::string& step) {
  command->add_option("step", step, "A step: 02, 2, 02-blinn-phong or a part of the name")->required();
}
void add_steps(CLI::App* command, std::vector<std::string>& steps) {
  command->add_option("step", steps, "Steps; default: all");
}
void add_json(CLI::App* command, bool& json) {
  command->add_flag("--json", json, "Print JSON for programs");
}
void add_context(CLI::App* command, std::string& context) {
  command
      ->add_option("--context", context,
                   "How to create the OpenGL context; default: OSMesa, or EGL if OSMesa is missing")
      ->check(CLI::IsMember({"osmesa", "egl", "window"}));
}
void add_earlier(CLI::App* command, std::string& earlier) {
  command
      ->add_option("--earlier", earlier,
                   "Whose code to use for earlier steps; default: yours for steps that you have passed")
      ->check(CLI::IsMember({"mine", "solution"}));
}

void add_sources(CLI::App* command, std::filesystem::path& sources) {
  command->add_option("--sources", sources, "Folder of your NN-name folders; default: steps")
      ->check(CLI::ExistingDirectory);
}

void add_references(CLI::App* command, bool& live) {
  command
      ->add_option_function<std::string>(
          "--references", [&live](const std::string& which) { live = which == "live"; },
          "stored, or live: what the solution draws on this driver; default: stored")
      ->check(CLI::IsMember({"stored", "live"}));
}

struct AllOptions {
  ListOptions list;
  CheckOptions check;
  ExplainOptions explain;
  WatchOptions watch;
  RunOptions run;
  HintOptions hint;
  ProgressOptions progress;
  NextOptions next;
  ResetOptions reset;
  CompareOptions compare;
  DoctorOptions doctor;
  SubmitOptions submit;
  GradeOptions grade;
  GradeWorkerOptions grade_worker;
  CourseCheckOptions course_check;
  ReleaseOptions release;
  AuditOptions audit;
  VaryOptions vary;
  ReferenceOptions reference;
  SkeletonOptions skeleton;
  NewStepOptions new_step;
  TablesOptions tables;
  MistakeOptions mistake;
  MutateOptions mutate;
  BenchOptions bench;
  MeasureOptions measure;
  StabilityOptions stability;
  TestOptions test;
};

void describe_for_students(Interface& interface, AllOptions& options) {
  CLI::App* list = interface.add("list", "The steps, their files, cases and points", options.list, run_list);
  add_json(list, options.list.json);

  CLI::App* check = interface.add("check", "Build, draw and judge your own files of a step", options.check, run_check);
  add_step(check, options.check.step);
  check->add_option("--case", options.check.cases, "Only this case; can be repeated");
  add_context(check, options.check.context);
  add_earlier(check, options.check.earlier);
  add_references(check, options.check.live);
  check->add_option("--report", options.check.report, "Folder of the report; default: out/check/STEP");
  add_sources(check, options.check.sources);
  check->add_flag("--table", options.check.table, "Also show a line for each case");
  check->add_flag("--heatmap", options.check.heatmap, "Show as text where a picture differs");
  check->add_flag("--skip-report", options.check.skip_report, "Print the verdict, but write no files");
  add_json(check, options.check.json);

  CLI::App* explain =
      interface.add("explain", "Show every intermediate result at a pixel of a case, and the first that differs",
                    options.explain, run_explain);
  add_step(explain, options.explain.step);
  explain->add_option("case", options.explain.case_name, "A case with a picture");
  explain->add_option("--pixel", options.explain.pixel,
                      "X,Y: whole numbers from the upper left corner, as in a report; default: where the picture "
                      "differs most, else its middle");
  add_context(explain, options.explain.context);
  add_earlier(explain, options.explain.earlier);
  add_sources(explain, options.explain.sources);
  add_json(explain, options.explain.json);

  CLI::App* watch = interface.add("watch", "Check at every save, and show one thing to fix", options.watch, run_watch);
  watch->add_option("step", options.watch.step, "A step; default: the first that you have not passed");
  add_context(watch, options.watch.context);
  add_earlier(watch, options.watch.earlier);
  add_references(watch, options.watch.live);

  CLI::App* run = interface.add("run", "Build your own files of a step and open its program", options.run, run_run);
  add_earlier(run, options.run.earlier);
  run->prefix_command()->footer("STEP, followed by arguments for its program: ./atelier run 02 --scene teapot");

  CLI::App* hint = interface.add("hint", "Show the next of a case's three hints", options.hint, run_hint);
  add_step(hint, options.hint.step);
  hint->add_option("case", options.hint.case_name, "A case; default: the first that failed in the last check");
  hint->add_option("--level", options.hint.level, "Show this level again, without counting it")
      ->check(CLI::Range(1, 3));

  CLI::App* progress = interface.add("progress", "Your progress in each step", options.progress, run_progress);
  add_json(progress, options.progress.json);

  interface.add("next", "The next step: its goal, its files and how to start", options.next, run_next);

  CLI::App* reset =
      interface.add("reset", "Reset your file to its skeleton, and keep a copy", options.reset, run_reset);
  reset->add_option("file", options.reset.file, "One of your files: 02/blinn_phong.cpp, or blinn_phong.cpp")
      ->required();
  reset->add_flag("--force", options.reset.force, "Do not ask for confirmation");

  CLI::App* compare = interface.add("compare", "Show your functions beside the solution's, once they have passed",
                                    options.compare, run_compare);
  add_step(compare, options.compare.step);
  compare->add_option("function", options.compare.function, "One of your functions; default: all that have passed");
  compare->add_flag("--spoil", options.compare.spoil, "Also functions that have not passed");

  CLI::App* doctor =
      interface.add("doctor", "Check this machine, and show how to fix each problem", options.doctor, run_doctor);
  add_json(doctor, options.doctor.json);
  doctor->add_option("--found", options.doctor.found)->group("");  // hidden: for the launcher and for doctor itself
  doctor->add_option("--install", options.doctor.install)->group("");
  doctor->add_option("--try", options.doctor.context)->group("");

  CLI::App* submit =
      interface.add("submit", "Pack your own files of a step to hand them in", options.submit, run_submit);
  add_step(submit, options.submit.step);
  submit->add_option("--out", options.submit.out, "The ZIP; default: out/submit/STEP.zip");
}

void describe_for_graders(Interface& interface, AllOptions& options) {
  GradeOptions& grade = options.grade;
  CLI::App* command = interface.add("grade", "Grade a submission", grade, run_grade);
  command
      ->add_option("submission", grade.submissions,
                   "A folder that contains a folder for each step, or an archive of it; or a class: a folder of "
                   "submissions as a course platform delivers it, or several submissions")
      ->required();
  command->add_option("--out", grade.out, "Folder of the results; default: out/grade/NAME");
  command->add_option("--step", grade.steps, "Grade this step, even if it is absent; can be repeated");
  command
      ->add_option("--workers", grade.workers,
                   "Number of programs that draw at the same time, or of a class submissions; default: two, or one for "
                   "each processor")
      ->check(CLI::Range(1, 1000));
  command->add_option("--course", grade.course, "Of a class: course.toml, with points, deadlines and columns");
  command->add_option("--cases", grade.cases, "Folder of further cases, NN-name/cases.json, that no student has seen");
  command->add_option("--engine", grade.engine, "Of a class: where it is graded: local, or slurm (a job array)")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  command->add_option("--engine-arguments", grade.engine_arguments, "For sbatch: \"--partition=short --time=2:00:00\"");
  command
      ->add_option("--sandbox", grade.sandbox,
                   "What confines a student's code: best (that works here), full, account or none")
      ->capture_default_str();
  command->add_option("--shuffle", grade.shuffle, "Run the cases in a random order, from this seed");
  command
      ->add_option("--seed", grade.seed,
                   "Draw the numbers of cases that vary from this seed; default: one that "
                   "depends on the files handed in, so that grading again repeats them")
      ->check(CLI::Range(std::uint64_t(0), grade::max_seed));
  add_context(command, grade.context);
  add_json(command, grade.json);

  CLI::App* worker = interface.add("grade-worker", "", options.grade_worker, run_grade_worker);
  worker->group("");  // hidden: for `grade`, which starts these processes
  worker->add_option("out", options.grade_worker.out)->required();
  worker->add_option("--index", options.grade_worker.index)->check(CLI::Range(0, 100'000));
  worker->add_option("--of", options.grade_worker.of)->check(CLI::Range(1, 100'000));

  CLI::App* course = interface.app.add_subcommand("course", "Rules that turn points into grades: course.toml");
  course->require_subcommand(1);
  CLI::App* course_check = interface.add_to(*course, "check", "Say what a course.toml means, or what is wrong with it",
                                            options.course_check, run_course_check);
  course_check->add_option("file", options.course_check.file, "The file")->capture_default_str();

  CLI::App* release = interface.add("release", "Make the students' version: no solutions, patches or hidden cases",
                                    options.release, run_release);
  release->add_option("step", options.release.steps, "Steps, or all")->required();
  release->add_option("--out", options.release.out, "A new or empty folder, or a file that ends in .zip")->required();
  release
      ->add_option("--earlier", options.release.earlier,
                   "What stands in for earlier steps that a student has not passed: their solutions in no readable "
                   "form, compiled for machines like this one (library); solutions as text, of steps that are not "
                   "released too (source); nothing (none)")
      ->check(CLI::IsMember({"none", "source", "library"}))
      ->capture_default_str();
}

void describe_measure(Interface& interface, MeasureOptions& options) {
  CLI::App* measure =
      interface.add("measure", "Measure error, time and memory of each setting, with plots", options, run_measure);
  add_step(measure, options.step);
  measure->add_option("--setting", options.setting,
                      "Only the sweeps of this setting; default: all, and the Pareto fronts");
  CLI::Option* out = measure->add_option("--out", options.out, "Folder of the results; default: out/measure/STEP");
  CLI::Option* frames = measure->add_option("--frames", options.frames, "Number of frames to time for each picture")
                            ->check(CLI::Range(1, 10000))
                            ->capture_default_str();
  CLI::Option* mine =
      measure->add_flag("--mine", options.mine, "Your own files; default: the solution, if there is one");
  CLI::Option* handout =
      measure->add_flag("--handout", options.handout, "Only draw the plots of the step's handout again");
  for (CLI::Option* unused : {out, frames, mine}) handout->excludes(unused);
  measure->add_flag("--check", options.check, "With --handout: write nothing; fail if a number has changed")
      ->needs(handout);
  add_context(measure, options.context);
  add_json(measure, options.json);
}

void describe_stability(Interface& interface, StabilityOptions& options) {
  CLI::App* stability = interface.add("stability", "Test every function at its extremes against double precision",
                                      options, run_stability);
  stability->add_option("step", options.step, "A step, or common; default: all");
  stability->add_option("--out", options.out, "Folder of the plots and of all rows as CSV; default: out/stability");
  stability->add_flag("--all", options.all, "Print every row, not only the worst");
  add_json(stability, options.json);
}

void describe_mutate(Interface& interface, MutateOptions& options) {
  CLI::App* mutate =
      interface.add("mutate", "Make small changes to solutions; each must lose points", options, run_mutate);
  add_steps(mutate, options.steps);
  mutate->add_option("--seed", options.seed, "Seed for choosing the changes")->capture_default_str();
  mutate->add_option("--count", options.count, "Number of changes that compile, per step")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  auto* preserving =
      mutate->add_flag("--preserving", options.preserving, "Make equivalent code instead, which must keep all points");
  mutate
      ->add_flag("--last-bits", options.last_bits,
                 "Change earlier steps' results by one unit in the last place; all points must be kept")
      ->excludes(preserving);
  mutate
      ->add_option("--patches", options.patches,
                   "Judge known mistakes in others' words instead: NAME.*.patch in this folder; say how they are named")
      ->check(CLI::ExistingDirectory)
      ->excludes(preserving);
  add_json(mutate, options.json);
}

void describe_mistake(Interface& interface, MistakeOptions& options) {
  CLI::App* mistake =
      interface.add("mistake", "Make a known mistake from an edited copy of the solution", options, run_mistake);
  add_step(mistake, options.step);
  mistake->add_option("name", options.name, "Its name, for example half-forgotten");
  auto* begin = mistake->add_flag("--begin", options.begin, "Make the copy to edit");
  auto* spelling = mistake->add_flag("--spelling", options.spelling, "Another spelling of an existing mistake");
  auto* variant = mistake->add_flag("--variant", options.variant, "Not a mistake, but another correct solution");
  auto* from = mistake->add_option("--from", options.from, "The edited copy; default: out/mistake/STEP");
  auto* rebase = mistake->add_option("--rebase", options.rebase,
                                     "Update all patches; they apply to the solution of this git revision");
  for (CLI::Option* unused : {begin, spelling, variant, from}) rebase->excludes(unused);
}

void describe_for_authors(Interface& interface, AllOptions& options) {
  CLI::App* new_step =
      interface.add("new-step", "Create all files of a new step from a template", options.new_step, run_new_step);
  new_step->add_option("step", options.new_step.step, "Number and name, for example 13-old-film")->required();
  new_step->add_option("--title", options.new_step.title, "Its title; default: made from the name");

  describe_mistake(interface, options.mistake);
  describe_mutate(interface, options.mutate);

  CLI::App* tables = interface.add("tables", "Write the rows of all steps in README.md and handouts/README.md",
                                   options.tables, run_tables);
  tables->add_flag("--check", options.tables.check, "Write nothing; fail if a row would change");

  CLI::App* skeleton =
      interface.add("skeleton", "Make the students' files from the solutions", options.skeleton, run_skeleton);
  add_steps(skeleton, options.skeleton.steps);
  skeleton->add_flag("--check", options.skeleton.check, "Write nothing; fail if something would change");
  skeleton->add_flag("--force", options.skeleton.force, "Overwrite files that have been edited");

  CLI::App* reference =
      interface.add("reference", "Draw the reference pictures with the solution", options.reference, run_reference);
  add_steps(reference, options.reference.steps);
  reference->add_option("--case", options.reference.cases, "Only this case; can be repeated");
  reference->add_flag("--check", options.reference.check, "Write nothing; fail if something would change");
  add_json(reference, options.reference.json);

  CLI::App* audit =
      interface.add("audit", "Prove that every mistake is caught and every variant passes", options.audit, run_audit);
  add_steps(audit, options.audit.steps);
  audit->add_option("--out", options.audit.out, "Also write the JSON to this file");
  audit
      ->add_option("--sample", options.audit.sample,
                   "Judge one in this many mistakes and variants; the patches of all must apply")
      ->check(CLI::Range(1, 1000));
  add_json(audit, options.audit.json);

  CLI::App* vary = interface.add("vary", "Prove the same of the cases whose numbers are drawn for each submission",
                                 options.vary, run_vary);
  add_steps(vary, options.vary.steps);
  vary->add_option("--seed", options.vary.seed, "The first seed")
      ->check(CLI::Range(std::uint64_t(0), grade::max_seed - 1000))
      ->capture_default_str();
  vary->add_option("--seeds", options.vary.seeds, "Number of seeds")->check(CLI::Range(1, 1000))->capture_default_str();
  vary->add_option("--pictures", options.vary.pictures, "Write the solution's pictures to this folder");
  add_json(vary, options.vary.json);

  CLI::App* bench =
      interface.add("bench", "Measure the time from an edit to its verdict, and its parts", options.bench, run_bench);
  bench->add_option("step", options.bench.step, "The step to measure")->capture_default_str();
  bench->add_option("--repeats", options.bench.repeats, "Runs per measurement; the median is reported")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  bench->add_flag("--baseline", options.bench.baseline,
                  "Only compare: the step's frames with a baseline's and with one another, its work with packages'");
  add_json(bench, options.bench.json);

  describe_measure(interface, options.measure);
  describe_stability(interface, options.stability);

  CLI::App* test = interface.add("test", "Run the project's tests", options.test, run_test);
  auto* quick = test->add_flag_callback(
      "--quick", [&] { options.test.tier = TestOptions::Tier::quick; }, "Under three minutes");
  auto* all =
      test->add_flag_callback(
              "--all", [&] { options.test.tier = TestOptions::Tier::all; }, "All tests, including the long ones")
          ->excludes(quick);
  test->add_option("--step", options.test.step, "Only the tests of this step")->excludes(quick)->excludes(all);
}

/// In a release: hides those commands, and refuses the one that is named.
void leave_out_of_release(CLI::App& app, const std::string& named) {
  for (const char* name : for_whole_project) {
    if (named == name)
      throw Error(fmt::format(
          "{}: a release has no tests and no solutions to read, which this command needs; ./atelier help lists those "
          "that are here",
          named));
    app.get_subcommand(name)->group("");
  }
}

/// CLI11 would only say that a command is missing; this suggests the nearest one.
void refuse_unknown_command(const CLI::App& app, const std::string& named) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands({}))
    if (!command->get_group().empty()) known.push_back(command->get_name());
  const std::string of = app.get_parent() == nullptr ? "" : app.get_name() + ": ";
  if (named.empty()) throw Error(fmt::format("{}a command is missing{}", of, suggestion(named, known)));
  const auto is_named = [&](const CLI::App* command) { return command->get_name() == named; };
  if (std::ranges::none_of(app.get_subcommands({}), is_named))  // hidden ones too
    throw Error(fmt::format("{}there is no command '{}'{}", of, named, suggestion(named, known)));
}

/// The first argument is the step, the rest are for its program, except --earlier.
void take_arguments_of_run(const std::vector<std::string>& given, RunOptions& run) {
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i] == "--earlier" && i + 1 < given.size())
      run.earlier = given[++i];
    else if (given[i].starts_with("--earlier="))
      run.earlier = given[i].substr(given[i].find('=') + 1);
    else
      (run.step.empty() ? run.step : run.arguments.emplace_back()) = given[i];
  }
}

int run(int count, char** arguments) {
  AllOptions options;
  Interface interface;
  interface.app.name("./atelier");
  interface.app.require_subcommand(1);
  describe_for_students(interface, options);
  describe_for_graders(interface, options);
  describe_for_authors(interface, options);
  const std::string named = count < 2 || arguments[1][0] == '-' ? "" : arguments[1];
  if (is_release()) leave_out_of_release(interface.app, named);
  if (!named.empty()) refuse_unknown_command(interface.app, named);
  if (named == "course" && (count < 3 || arguments[2][0] != '-'))
    refuse_unknown_command(*interface.app.get_subcommand(named), count < 3 ? "" : arguments[2]);
  try {
    interface.app.parse(count, arguments);
  } catch (const CLI::CallForHelp& help) {
    return interface.app.exit(help);
  } catch (const CLI::ParseError& error) {
    throw Error(std::string(error.what()) + " (see ./atelier --help)");
  }
  take_arguments_of_run(interface.app.get_subcommand("run")->remaining(), options.run);
  // doctor must not change anything.
  if (!interface.app.got_subcommand("doctor"))
    for (const std::string& line : update_skeletons(project_folders())) fmt::print(stderr, "{}\n", line);
  return interface.action();
}

}  // namespace
}  // namespace atelier

int main(int count, char** arguments) {
  // The reader of stdout may exit early, as in "| head". Ignore SIGPIPE, so that destructors still run; then exit with
  // the status that a shell reports for SIGPIPE.
  ::signal(SIGPIPE, SIG_IGN);
  constexpr int broken_pipe = 128 + SIGPIPE;
  int status = atelier::exit_usage;
  try {
    status = atelier::run(count, arguments);
    // Report output that a pipe or a full disk did not accept.
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
      throw atelier::Error("the output could not be written in full");
  } catch (const std::exception& error) {
    if (std::fflush(stdout) != 0 || std::ferror(stdout)) {
      pollfd listener{STDOUT_FILENO, POLLOUT, 0};
      if (::poll(&listener, 1, 0) == 1 && (listener.revents & POLLERR)) return broken_pipe;
    }
    fmt::print(stderr, "error: {}\n", error.what());
    status = atelier::exit_usage;
  }
  return status;
}
