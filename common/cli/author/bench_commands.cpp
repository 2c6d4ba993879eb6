// Times whole commands.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "cli/author/bench.hpp"
#include "cli/search_path.hpp"
#include "cli/student/own_check.hpp"
#include "judge/run/runner.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using judge::JudgedCase;

constexpr std::size_t usual_cases = 10;
constexpr glm::ivec2 usual_size{256, 256};

/// Ten picture cases of 256x256, or as many as the step has.
std::vector<JudgedCase> pick_cases(const std::vector<JudgedCase>& all) {
  std::vector<JudgedCase> picked;
  for (const JudgedCase& c : all)
    if (c.ask.probe.empty() && c.ask.size == usual_size && picked.size() < usual_cases) picked.push_back(c);
  if (picked.empty()) throw Error("bench: this step has no picture case of 256x256 pixels; choose another step");
  return picked;
}

/// Runs a command; throws Error if it fails.
void must_run(const std::vector<std::string>& arguments) {
  const Finished finished = run_process({.arguments = arguments});
  if (!finished.ok())
    throw Error(fmt::format("bench: {} does not work: {}", arguments.front(), finished.output.substr(0, 500)));
}

/// Appends a comment, which forces a new build without changing behaviour.
void edit(const fs::path& file) {
  std::ofstream out(file, std::ios::app);
  out << "// edited\n";
  if (!out.flush()) throw Error(file.string() + ": cannot be written");
}

/// The first file of the step with this extension, or an empty path.
fs::path file_with(const CourseStep& step, const std::string& ending) {
  for (const std::string& file : step.files)
    if (file.ends_with(ending)) return file;
  return {};
}

std::vector<std::string> names_of(const std::vector<JudgedCase>& cases) {
  std::vector<std::string> names;
  for (const JudgedCase& c : cases) names.push_back(c.ask.name);
  return names;
}

/// An edit of each kind of file, in a copy of the solution.
std::vector<Figure> bench_edits(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                                const CourseStep& step, const std::vector<JudgedCase>& cases, int repeats) {
  const TemporaryFolder copy("atelier-bench");
  judge::take_step_files(judge::read_step_flags(folders.step_flags()), step.name, folders.solutions() / step.name,
                         copy.path() / step.name);
  std::vector<std::string> check = {(folders.root / "atelier").string(),
                                    "check",
                                    step.name,
                                    "--skip-report",
                                    "--earlier",
                                    "solution",
                                    "--sources",
                                    copy.path().string()};
  for (const std::string& name : names_of(cases)) check.insert(check.end(), {"--case", name});
  must_run(check);  // builds what is missing, decodes the references

  std::vector<Figure> figures;
  const auto cold = [&] { fs::remove_all(folders.shader_cache()); };
  const std::string detail = fmt::format("{} cases of 256x256, cold shader cache", cases.size());
  const auto add = [&](const char* name, const char* ending, double limit, const std::function<void()>& judge) {
    const fs::path file = file_with(step, ending);
    if (file.empty()) return;
    figures.push_back(time_runs(name, detail, repeats, judge, [&] { cold(), edit(copy.path() / step.name / file); }));
    figures.back().limit = limit;
  };
  const auto by_check = [&] { must_run(check); };
  add("edit to verdict, GLSL", ".glsl", 0.5, by_check);
  add("edit to verdict, C++", ".cpp", 1.0, by_check);
  OwnCheck watched(folders, course, step, {.cases = names_of(cases), .earlier = "solution", .sources = copy.path()});
  const auto by_watch = [&] {
    if (!grade::all_passed(watched.judge())) throw Error("bench: the solution does not pass");
  };
  by_watch();  // warm up: references are in memory
  add("save to verdict in watch, GLSL", ".glsl", 0.5, by_watch);
  add("save to verdict in watch, C++", ".cpp", 1.0, by_watch);
  figures.push_back(time_runs("nothing changed", fmt::format("{} cases, warm shader cache", cases.size()), repeats,
                              [&] { must_run(check); }));
  return figures;
}

std::vector<Figure> bench_start(const ProjectFolders& folders, const CourseStep& step, int repeats) {
  const std::string launcher = (folders.root / "atelier").string(),
                    program = (folders.build / "bin" / "atelier").string();
  Figure with = time_runs("launcher", "./atelier list less the program alone: nothing to build", repeats, [&] {
    must_run({launcher, "list"});
  });
  const Figure without = time_runs("", "", repeats, [&] { must_run({program, "list"}); });
  with.seconds -= without.seconds, with.least -= without.seconds, with.most -= without.seconds;
  with.limit = 0.2;
  const Figure start = time_runs("start of a step program", "--list", repeats, [&] {
    must_run({folders.program(step.name).string(), "--list", "--implementations",
              search_path(folders, step, code_of(folders, Owner::solution), {}).to_string()});
  });
  return {with, start};
}

/// The driver's shader compiler takes most of the time of a cold run. GALLIVM_PERF=nopt, which the judge always sets,
/// halves it and changes no pixel.
std::vector<Figure> bench_shaders(const ProjectFolders& folders, const CourseStep& step,
                                  const std::vector<JudgedCase>& cases, int repeats) {
  const TemporaryFolder cache("atelier-bench-shaders");
  std::vector<Case> asks;
  for (const JudgedCase& c : cases) asks.push_back(c.ask);
  judge::RunSettings settings;
  settings.program = folders.program(step.name);
  settings.implementations = search_path(folders, step, code_of(folders, Owner::solution), {});
  settings.shader_cache = cache.path() / "shaders";
  std::vector<Figure> figures;
  for (const bool optimised : {false, true}) {
    settings.environment["GALLIVM_PERF"] = optimised ? "" : "nopt";
    figures.push_back(time_runs(
        optimised ? "drawing, shaders optimised" : "drawing, shaders as they are",
        fmt::format("{} cases, two workers, cold shader cache", cases.size()), repeats,
        [&] { judge::run_cases(settings, asks); }, [&] { fs::remove_all(settings.shader_cache); }));
  }
  return figures;
}

}  // namespace

std::vector<Figure> bench_commands(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                                   const CourseStep& step, int repeats) {
  const auto cases = pick_cases(judge::read_case_file(folders.case_file(step.name)).cases);
  std::vector<Figure> figures = bench_edits(folders, course, step, cases, repeats);
  for (const auto& part : {bench_start(folders, step, repeats), bench_shaders(folders, step, cases, repeats)})
    figures.insert(figures.end(), part.begin(), part.end());
  return figures;
}

}  // namespace atelier
