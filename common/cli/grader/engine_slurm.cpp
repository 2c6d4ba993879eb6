#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/launch.hpp"
#include "base/printable.hpp"
#include "base/process.hpp"
#include "base/stopwatch.hpp"
#include "cli/grader/engine.hpp"
#include "judge/run/runner.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

constexpr int scheduler_poll_ms = 250;
constexpr double ask_seconds = 5;       ///< between two questions to the scheduler, which serves everybody
constexpr double silent_seconds = 600;  ///< so long the scheduler may be out of reach
constexpr int most_idle_arrays = 2;     ///< one after the other, that have graded nothing

/// Why an array waits that will never start, whatever else ends or comes back (squeue(1), JOB REASON CODES).
const std::set<std::string> hopeless = {
    "BadConstraints", "PartitionNodeLimit",       "PartitionTimeLimit",         "InvalidAccount",
    "InvalidQOS",     "DependencyNeverSatisfied", "launch failed requeued held"};
/// Why arrays usually wait, which is no news.
const std::set<std::string> usual = {"None", "Resources", "Priority", "BeginTime", "JobArrayTaskLimit", "Cleaning"};

/// What a command of Slurm has printed, as one sentence.
std::string in_one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::ranges::replace(text, '\n', ' ');
  return shorten(printable(text), 500);
}

class SlurmEngine {
 public:
  SlurmEngine(const EngineSettings& settings, const ClassPlan& plan)
      : settings_(settings), plan_(plan), ends_(settings.places, plan) {}

  void run() {
    clean_up();
    int idle_arrays = 0;
    for (std::size_t left = ungraded(settings_.places, plan_).size(); left > 0;) {
      const int tasks = int(std::min(left, std::size_t(settings_.workers)));
      submit(tasks);
      wait_for_array();
      forget_array();
      bool had_work = false;
      for (int i = 0; i < tasks; ++i) had_work |= ends_.note(i, fmt::format("see {}", log_of(std::to_string(i))));
      const std::size_t before = std::exchange(left, ungraded(settings_.places, plan_).size());
      idle_arrays = left < before || had_work ? 0 : idle_arrays + 1;
      if (idle_arrays == most_idle_arrays)
        throw Error(fmt::format("slurm: {} job arrays have graded nothing; the end of a log in {}: {}", idle_arrays,
                                settings_.places.state().string(), last_words()));
    }
  }

 private:
  std::string log_of(const std::string& task) const {
    return (settings_.places.state() / ("slurm-" + task + ".log")).string();
  }

  /// The file with the number of the array: a `grade` that is killed leaves its array behind.
  fs::path array_file() const { return settings_.places.state() / "slurm-array"; }

  Finished ask(std::vector<std::string> arguments) const {
    return run_process({.arguments = std::move(arguments), .environment = settings_.temporary.environment_before()});
  }

  std::string demand(std::vector<std::string> arguments) const {
    const Finished done = ask(std::move(arguments));
    if (!done.ok()) throw Error(in_one_line(done.output));
    return done.output;
  }

  /// Removes what an earlier run has left, above all its array.
  void clean_up() {
    std::error_code none;
    if (fs::exists(array_file(), none)) {
      array_ = read_file(array_file());
      cancel();
      forget_array();
    }
    std::vector<fs::path> logs;
    for (const auto& entry : fs::directory_iterator(settings_.places.state()))
      if (entry.path().extension() == ".log" || entry.path().filename().string().starts_with("worker-"))
        logs.push_back(entry.path());
    for (const fs::path& log : logs) fs::remove(log, none);
  }

  void cancel() const {
    if (array_.find_first_not_of("0123456789") == array_.npos && !array_.empty()) ask({"scancel", array_});
  }

  void forget_array() {
    std::error_code none;
    fs::remove(array_file(), none);
    array_.clear();
  }

  /// What each task of the array runs; it may run again, on another machine. The environment comes from this machine,
  /// and so may name a temporary folder that the other has not.
  fs::path write_script(int tasks) const {
    std::string command = "exec";
    for (const std::string& word : worker_command(settings_.places, "$SLURM_ARRAY_TASK_ID", tasks))
      command += ' ' + (word.starts_with('$') ? '"' + word + '"' : shell_word(word));
    const fs::path script = settings_.places.state() / "slurm.sh";
    write_file(script,
               "#!/bin/sh\n# One of the processes that grade the class; made by ./atelier grade.\n"
               "[ -w \"${TMPDIR:-/}\" ] || unset TMPDIR\n" +
                   command + "\n");
    return script;
  }

  void submit(int tasks) {
    std::vector<std::string> arguments = {"sbatch",
                                          "--parsable",
                                          "--requeue",
                                          "--open-mode=append",
                                          "--job-name=atelier",
                                          "--chdir=/",
                                          fmt::format("--array=0-{}", tasks - 1),
                                          fmt::format("--output={}", log_of("%a"))};
    std::istringstream more(settings_.arguments);
    for (std::string argument; more >> argument;) arguments.push_back(argument);
    arguments.push_back(write_script(tasks).string());
    array_ = demand(std::move(arguments));  // "12" or "12;cluster", perhaps after warnings
    array_.resize(array_.find_last_not_of('\n') + 1);
    array_.erase(0, array_.rfind('\n') + 1);
    array_.resize(std::min(array_.find(';'), array_.size()));
    write_file(array_file(), array_);
  }

  void wait_for_array() {
    Stopwatch since_asked, since_answered;
    while (!ungraded(settings_.places, plan_).empty()) {
      if (settings_.interrupted && settings_.interrupted()) {
        cancel();
        forget_array();
        throw judge::Interrupted();
      }
      if (settings_.waiting) settings_.waiting();
      ::poll(nullptr, 0, scheduler_poll_ms);
      if (since_asked.seconds() < ask_seconds) continue;
      since_asked = {};
      const Finished answer = ask({"squeue", "--noheader", "--jobs=" + array_, "--format=%t %r"});
      if (answer.ok() || answer.output.find("Invalid job id") != std::string::npos) {
        since_answered = {};
        if (!answer.ok() || !has_tasks(answer.output)) return;  // the scheduler forgets what has ended
      } else if (since_answered.seconds() > silent_seconds) {
        throw Error(in_one_line(answer.output));
      }
    }
    ask({"scancel", "--state=PENDING", array_});  // tasks that would find nothing to do
  }

  /// Whether tasks wait or run, from lines such as "PD Resources". Says why they wait, and gives up if it is for ever.
  bool has_tasks(const std::string& lines) {
    bool any = false, any_runs = false;
    std::string reason;
    std::istringstream all(lines);
    for (std::string line; std::getline(all, line);) {
      if (line.empty()) continue;
      any = true;
      if (line.starts_with("PD "))
        reason = line.substr(3);
      else
        any_runs = true;
    }
    if (any_runs || reason.empty() || usual.contains(reason)) return any;
    if (hopeless.contains(reason)) {
      cancel();
      forget_array();
      throw Error(fmt::format("slurm: the job array cannot start ({}); see --engine-arguments", printable(reason)));
    }
    if (reason != said_)
      fmt::print(stderr, "{}Slurm: job array {} waits: {}\n", start_of_line(), array_, printable(reason));
    said_ = reason;
    return any;
  }

  /// On a terminal, the line of progress gives way.
  static const char* start_of_line() { return ::isatty(STDERR_FILENO) ? "\r\x1b[K" : ""; }

  /// The end of the log that was written last, for an error.
  std::string last_words() const {
    std::string words;
    fs::file_time_type latest = fs::file_time_type::min();
    for (const auto& entry : fs::directory_iterator(settings_.places.state())) {
      if (entry.path().extension() != ".log" || entry.file_size() == 0 || entry.last_write_time() < latest) continue;
      latest = entry.last_write_time();
      const std::string log = read_file(entry.path());
      words = log.substr(log.size() - std::min<std::size_t>(log.size(), 400));
    }
    return shorten(printable(words), 400);
  }

  const EngineSettings& settings_;
  const ClassPlan& plan_;
  WorkerEnds ends_;
  std::string array_;  ///< the number of the array
  std::string said_;   ///< why it waits
};

}  // namespace

void require_slurm() {
  for (const char* program : {"sbatch", "squeue", "scancel"}) try {
      find_program(program);
    } catch (const Error&) {
      throw Error(
          fmt::format("--engine slurm: the program {} is not here; start `grade` on a machine from which jobs "
                      "are submitted, or leave --engine out",
                      program));
    }
}

void run_slurm_engine(const EngineSettings& settings, const ClassPlan& plan) {
  SlurmEngine(settings, plan).run();
}

}  // namespace atelier
