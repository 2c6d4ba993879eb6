// Times the grading of a class: solutions, variants and known mistakes of the first steps, in and without a sandbox.
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "cli/author/bench.hpp"
#include "cli/grader/class_progress.hpp"
#include "grade/results/record.hpp"
#include "judge/compare/mistakes.hpp"
#include "judge/run/source_file.hpp"
#include "judge/run/worker.hpp"
#include "measure/median.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t first_step = 1, steps_of_class = 4;  ///< after 00-hello, which has no C++
constexpr int class_to_compare = 300;

/// How one submission solves a step; an empty patch is the solution.
std::vector<fs::path> patches_of(const ProjectFolders& folders, const CourseStep& step) {
  std::vector<fs::path> patches = {fs::path()};
  for (const judge::Variant& variant : judge::read_variants(folders.variants_file(step.name)))
    patches.push_back(variant.patch);
  for (const judge::Mistake& mistake : judge::read_mistakes(folders.mistakes_file(step.name)))
    patches.push_back(mistake.patch);
  return patches;
}

void write_class(const ProjectFolders& folders, const std::vector<CourseStep>& steps, int count, const fs::path& out) {
  for (std::size_t s = 0; s < steps.size(); ++s) {
    const std::vector<fs::path> patches = patches_of(folders, steps[s]);
    for (int i = 0; i < count; ++i) {
      const fs::path folder = out / fmt::format("student-{:03}", i) / steps[s].name;
      const fs::path& patch = patches[(std::size_t(i) * 7 + s * 3) % patches.size()];
      fs::create_directories(folder.parent_path());
      if (patch.empty())
        fs::copy(folders.solutions() / steps[s].name, folder);
      else
        judge::make_patched(folders.solutions() / steps[s].name, patch, folder);
    }
  }
}

/// Resident memory of the processes that grade, in MiB, all together.
double memory_of_workers() {
  double kib = 0;
  std::error_code error;
  for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
    std::ifstream command(entry->path() / "cmdline"), status(entry->path() / "status");
    std::string line;
    if (!std::getline(command, line) || line.find(std::string("grade-worker") + '\0') == line.npos) continue;
    while (std::getline(status, line))
      if (line.starts_with("VmRSS:")) kib += std::stod(line.substr(6));
  }
  return kib / 1024;
}

struct ClassRun {
  double seconds = 0;                        ///< wall-clock
  std::map<std::string, double> kinds;       ///< seconds of work a submission, by kind: mean
  double early_memory = 0, late_memory = 0;  ///< MiB: medians of the second and of the last quarter
};

ClassRun grade_class(const fs::path& folder, const std::vector<CourseStep>& steps, const std::string& sandbox) {
  const TemporaryFolder out("atelier-bench");
  std::vector<std::string> command = {fs::read_symlink("/proc/self/exe").string(),
                                      "grade",
                                      folder.string(),
                                      "--out",
                                      out.path().string(),
                                      "--sandbox",
                                      sandbox};
  for (const CourseStep& step : steps) command.insert(command.end(), {"--step", step.name});
  const Stopwatch watch;
  judge::Worker process({.arguments = command, .folder = {}, .environment = own_environment(), .descriptors = {}});
  std::string output;
  std::vector<double> memory;
  std::optional<judge::Exit> exit;
  while (!(exit = process.ended())) {
    ::poll(nullptr, 0, 200);
    output += process.take_output();
    if (const double now = memory_of_workers(); now > 0) memory.push_back(now);
  }
  ClassRun run{.seconds = watch.seconds(), .kinds = {}};
  if (exit->status != exit_ok) throw Error("bench: the class was not graded: " + output + process.take_output());
  std::size_t records = 0;
  for (const auto& entry : fs::directory_iterator(out.path() / "students")) {
    for (const auto& [kind, seconds] : grade::read_record(entry.path() / "record.json").seconds)
      run.kinds[kind] += seconds;
    ++records;
  }
  for (auto& [kind, seconds] : run.kinds) seconds /= double(records);
  const auto quarter = [&](std::size_t k) {
    const auto begin = memory.begin() + std::ptrdiff_t(memory.size() * k / 4);
    const auto end = memory.begin() + std::ptrdiff_t(memory.size() * (k + 1) / 4);
    return begin == end ? 0 : measure::median({begin, end});
  };
  run.early_memory = quarter(1), run.late_memory = quarter(3);
  return run;
}

double sum(const ClassRun& run) {
  double all = 0;
  for (const auto& [kind, seconds] : run.kinds) all += seconds;
  return all;
}

}  // namespace

void bench_class(const ProjectFolders& folders, const std::vector<CourseStep>& course, int count) {
  const std::vector<CourseStep> steps(course.begin() + first_step, course.begin() + first_step + steps_of_class);
  const TemporaryFolder folder("atelier-bench");
  write_class(folders, steps, count, folder.path() / "class");
  const ClassRun with = grade_class(folder.path() / "class", steps, "best");
  const ClassRun without = grade_class(folder.path() / "class", steps, "none");

  fmt::print("{} submissions of {} steps, {} at a time\n", count, steps.size(), worker_threads());
  fmt::print("seconds a submission, mean      in the sandbox   without\n");
  for (const auto& [kind, seconds] : with.kinds)
    fmt::print("  {:<28} {:>14.3f} {:>10.3f}\n", kind, seconds,
               without.kinds.contains(kind) ? without.kinds.at(kind) : 0);
  fmt::print("  {:<28} {:>14.3f} {:>10.3f}\n", "all", sum(with), sum(without));
  const double drawing =
      with.kinds.at("compile") + with.kinds.at("start") + with.kinds.at("render") + with.kinds.at("solution");
  fmt::print("neither compiler nor programs: {:.1f} %\n", 100 * (1 - drawing / sum(with)));
  fmt::print("the sandbox: {:+.1f} % of the wall-clock time\n", 100 * (with.seconds / without.seconds - 1));
  fmt::print("memory of the processes that grade: {:.0f} MiB in the second quarter, {:.0f} MiB in the last\n",
             with.early_memory, with.late_memory);
  fmt::print("a class of {}: about {}\n", class_to_compare, duration_words(with.seconds / count * class_to_compare));
}

}  // namespace atelier
