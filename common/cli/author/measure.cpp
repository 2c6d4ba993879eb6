// ./atelier measure: the cost of each setting of a step, and how much it reduces the error.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "cli/author/step_rules.hpp"
#include "cli/commands.hpp"
#include "cli/layout.hpp"
#include "cli/search_path.hpp"
#include "cli/student/own_files.hpp"
#include "grade/environment.hpp"
#include "measure/charts.hpp"
#include "measure/expect.hpp"
#include "measure/page.hpp"
#include "measure/tables.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using measure::Finding;
using measure::Plan;
using measure::Program;

/// The solution, or the student's own files if there is none or if they are requested.
Program program_of(const ProjectFolders& folders, const std::vector<CourseStep>& course, const CourseStep& step,
                   const MeasureOptions& options) {
  Program program{.file = folders.program(step.name), .context = options.context};
  program.shader_cache =
      folders.build / "cache" / "measure-shaders";  // separate from the judge's cache: these shaders are optimised
  if (!options.mine && is_solution_readable(folders, step)) {
    program.implementations = search_path(folders, step, code_of(folders, Owner::solution), {});
    return program;
  }
  const OwnFiles own = prepare_own_files(folders, course, step, code_of(folders, Owner::mine), "");
  if (!own.built.ok) throw Error(fmt::format("{} does not build:\n{}", step.name, own.built.log));
  program.implementations = own.path;
  return program;
}

/// Keeps only the sweeps of one setting. Throws Error if there are none.
void keep_setting(Plan& plan, const std::string& setting) {
  if (setting.empty()) return;
  std::set<std::string> measured;
  for (const auto& sweep : plan.sweeps) measured.insert({sweep.setting, sweep.curves_by});
  measured.erase("");
  std::erase_if(plan.sweeps, [&](const auto& s) { return s.setting != setting && s.curves_by != setting; });
  plan.fronts.clear();
  if (!plan.sweeps.empty()) return;
  if (const auto why = plan.not_measured.find(setting); why != plan.not_measured.end())
    throw Error(fmt::format("--setting {}: it is not measured: {}", setting, why->second));
  throw Error(fmt::format("--setting {}: {} has no sweep of it{}", setting, plan.step,
                          suggestion(setting, {measured.begin(), measured.end()})));
}

/// Shows which sweep is being drawn on one line, only on a terminal.
void show_progress(std::size_t place, std::size_t count, const std::string& name) {
  if (::isatty(STDERR_FILENO)) fmt::print(stderr, "\r\033[K{} of {}: {}", place, count, name), std::fflush(stderr);
}
void clear_progress() {
  if (::isatty(STDERR_FILENO)) fmt::print(stderr, "\r\033[K");
}

measure::StepMeasured carry_out(const Plan& plan, const Program& program, const measure::Listing& listing,
                                int repeats) {
  measure::StepMeasured measured{.step = plan.step};
  const std::size_t count = plan.sweeps.size() + plan.fronts.size();
  std::size_t place = 0;
  for (const auto& sweep : plan.sweeps) {
    show_progress(++place, count, sweep.name);
    measured.sweeps.push_back(measure::run_sweep(program, listing, sweep, {.repeats = repeats}));
  }
  for (const auto& front : plan.fronts) {
    show_progress(++place, count, front.name);
    measured.fronts.push_back(measure::run_front(program, listing, front, {.repeats = repeats}));
  }
  clear_progress();
  return measured;
}

std::vector<Finding> all_findings(const measure::StepMeasured& measured) {
  std::vector<Finding> all;
  for (const auto& sweep : measured.sweeps)
    for (Finding& finding : measure::findings(sweep)) all.push_back(std::move(finding));
  return all;
}

bool all_met(const std::vector<Finding>& findings) {
  return std::all_of(findings.begin(), findings.end(), [](const Finding& f) { return f.met; });
}

void write_results(const measure::StepMeasured& measured, const fs::path& out) {
  write_file(out / "measure.csv", measure::as_csv(measured));
  write_file(out / "measure.json", measure::as_json(measured));
  const auto plot = [&](const std::string& name, const std::optional<measure::Plot>& chart) {
    if (chart) write_file(out / (name + ".svg"), measure::plot_as_svg(*chart));
  };
  for (const auto& sweep : measured.sweeps) {
    plot(sweep.plan.name, measure::chart_of_errors(sweep));
    plot(sweep.plan.name + "-time", measure::chart_of_times(sweep));
  }
  for (const auto& front : measured.fronts) plot(front.plan.name, measure::chart_of_front(front));
  write_file(out / "index.html", measure::page(measured));
}

void print_findings(const measure::StepMeasured& measured) {
  for (const Finding& finding : all_findings(measured)) fmt::print("{} {}\n", finding.met ? "✓" : "✗", finding.words);
}

void print_results(const measure::StepMeasured& measured, const fs::path& out) {
  print_findings(measured);
  for (const auto& front : measured.fronts)
    if (const measure::Ranking ranking = measure::rank(front); ranking.knee)
      fmt::print("· {}: recommended {} ({:.2f} ms, {} {:.3g})\n", front.plan.name, front.points[*ranking.knee].value,
                 ranking.points[*ranking.knee].x * 1e3, to_string(front.plan.metric), ranking.points[*ranking.knee].y);
  fmt::print("{}\n", (out / "index.html").string());
}

/// Draws the handout's plots, or with `check` only compares their numbers with the stored ones.
int handle_handout(const ProjectFolders& folders, const CourseStep& step, Plan plan, const Program& program,
                   const measure::Listing& listing, bool check) {
  std::erase_if(plan.sweeps, [](const auto& sweep) { return !sweep.handout; });
  plan.fronts.clear();  // their times differ between machines
  if (plan.sweeps.empty()) throw Error(fmt::format("{}: no sweep of those asked for is in the handout", step.name));
  const measure::StepMeasured measured = carry_out(plan, program, listing, 0);
  int status = exit_ok;
  print_findings(measured);
  if (!all_met(all_findings(measured))) status = exit_failed;
  for (const auto& sweep : measured.sweeps) {
    const fs::path plot = folders.handouts() / "plots" / fmt::format("{}-{}", step.number(), sweep.plan.name);
    const fs::path numbers = plot.string() + ".csv", picture = plot.string() + ".svg";
    const std::string csv = measure::errors_as_csv(sweep);
    if (check) {
      const std::string words = fs::exists(picture) ? measure::difference(csv, read_file(numbers)) : "there is no plot";
      if (!words.empty()) status = exit_failed;
      fmt::print("{} {}: {}\n", words.empty() ? "✓" : "✗", numbers.string(), words.empty() ? "up to date" : words);
    } else {
      write_file(numbers, csv);
      write_file(picture, measure::plot_as_svg(measure::chart_of_errors(sweep)));
      fmt::print("{}\n", picture.string());
    }
  }
  return status;
}

}  // namespace

int run_measure(const MeasureOptions& options) {
  const ProjectFolders folders = project_folders();
  const auto course = read_course(folders.step_flags());
  const CourseStep step = resolve_step(course, options.step);
  const fs::path file = folders.measure_file(step.name);
  if (!fs::exists(file)) throw Error(fmt::format("{}: is missing, so there is nothing to measure", file.string()));
  Plan plan = measure::read_plan(file);
  if (options.handout && !is_solution_readable(folders, step))
    throw Error(fmt::format("--handout: its plots show the solution, and {} is not here",
                            (folders.solutions() / step.name).string()));
  const Program program = program_of(folders, course, step, options);
  const measure::Listing listing = measure::list_of(program);
  measure::check_against(plan, listing.settings, listing.output_names());
  keep_setting(plan, options.setting);
  if (!options.check && !measure::can_plot())
    throw Error("measure: gnuplot, which draws the plots, is not installed; ./atelier doctor says how to install it");
  if (options.handout) return handle_handout(folders, step, plan, program, listing, options.check);

  measure::StepMeasured measured = carry_out(plan, program, listing, options.frames);
  for (const auto& [name, value] : grade::describe_environment(options.context, folders.step_flags(), folders.root))
    measured.environment[name] = value;
  const fs::path out = options.out.empty() ? folders.out() / "measure" / step.name : options.out;
  write_results(measured, out);
  if (options.json)
    fmt::print("{}", measure::as_json(measured));
  else
    print_results(measured, out);
  // A student's own files and single settings need no further checks.
  const bool of_author = options.setting.empty() && !options.mine && is_solution_readable(folders, step);
  const Problems problems = of_author ? problems_of_measured(folders, measured) : Problems();
  if (!options.json) fmt::print("{}", in_lines(problems));
  return all_met(all_findings(measured)) && problems.empty() ? exit_ok : exit_failed;
}

}  // namespace atelier
