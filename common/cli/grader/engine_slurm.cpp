#include <fmt/format.h>
#include <poll.h>

#include <sstream>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/printable.hpp"
#include "base/process.hpp"
#include "base/stopwatch.hpp"
#include "cli/grader/class_worker.hpp"
#include "cli/grader/engine.hpp"
#include "judge/run/runner.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

constexpr int most_arrays = 3;
constexpr int scheduler_poll_ms = 250;
constexpr double ask_seconds = 5;  ///< between two questions to the scheduler, which serves everybody

std::string slurm(std::vector<std::string> arguments) {
  const std::string program = arguments.front();
  const Finished done = run_process({.arguments = std::move(arguments)});
  if (!done.ok()) throw Error(fmt::format("{}: {}", program, shorten(printable(done.output), 500)));
  return done.output;
}

/// What each task of the array runs; it may run again, on another machine.
fs::path write_script(const ClassPlaces& places, int tasks) {
  std::string command = "exec";
  for (const std::string& word : worker_command(places, "$SLURM_ARRAY_TASK_ID", tasks))
    command += ' ' + (word.starts_with('$') ? '"' + word + '"' : shell_word(word));
  const fs::path script = places.state() / "slurm.sh";
  write_file(script,
             "#!/bin/sh\n# One of the processes that grade the class; made by ./atelier grade.\n" + command + "\n");
  return script;
}

/// The number of the array.
std::string submit(const EngineSettings& settings, int tasks) {
  std::vector<std::string> arguments = {
      "sbatch",
      "--parsable",
      "--requeue",
      "--open-mode=append",
      "--job-name=atelier",
      fmt::format("--array=0-{}", tasks - 1),
      fmt::format("--output={}", (settings.places.state() / "slurm-%a.log").string())};
  std::istringstream more(settings.arguments);
  for (std::string argument; more >> argument;) arguments.push_back(argument);
  arguments.push_back(write_script(settings.places, tasks).string());
  std::string number = slurm(arguments);
  number.resize(std::min(number.find_first_of(";\n"), number.size()));
  return number;
}

/// Whether tasks of the array wait or run. The scheduler forgets what has ended, and then knows no such array.
bool is_queued(const std::string& array) {
  const Finished done = run_process({.arguments = {"squeue", "--noheader", "--jobs=" + array}});
  return done.ok() && done.output.find_first_not_of(" \n") != std::string::npos;
}

void wait_for(const EngineSettings& settings, const ClassPlan& plan, const std::string& array) {
  Stopwatch since_asked;
  while (!ungraded(settings.places, plan).empty()) {
    if (settings.interrupted && settings.interrupted()) {
      slurm({"scancel", array});
      throw judge::Interrupted();
    }
    if (settings.waiting) settings.waiting();
    ::poll(nullptr, 0, scheduler_poll_ms);
    if (since_asked.seconds() < ask_seconds) continue;
    since_asked = {};
    if (!is_queued(array)) return;
  }
}

/// The end of the logs, for an error.
std::string last_words(const ClassPlaces& places) {
  std::string words;
  for (const auto& entry : fs::directory_iterator(places.state()))
    if (entry.path().extension() == ".log") {
      const std::string log = read_file(entry.path());
      words = log.empty() ? words : log.substr(log.size() - std::min<std::size_t>(log.size(), 400));
    }
  return shorten(printable(words), 400);
}

}  // namespace

void run_slurm_engine(const EngineSettings& settings, const ClassPlan& plan) {
  std::size_t left = ungraded(settings.places, plan).size();
  for (int array = 0; array < most_arrays && left > 0; ++array) {
    const std::size_t before = left;
    wait_for(settings, plan, submit(settings, int(std::min(left, std::size_t(settings.workers)))));
    left = ungraded(settings.places, plan).size();
    if (left == before && array > 0)
      throw Error(fmt::format("slurm: two job arrays have graded nothing; the end of a log in {}: {}",
                              settings.places.state().string(), last_words(settings.places)));
  }
  for (const grade::HandedIn* handed_in : ungraded(settings.places, plan))
    record_failure(
        settings.places, plan, *handed_in,
        fmt::format("{} job arrays have not graded it: see {}", most_arrays, settings.places.state().string()));
}

}  // namespace atelier
