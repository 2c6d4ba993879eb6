// Runs a step program on cases and returns an answer for each, whatever the program does.
//
//   PROGRAM --cases JOB --out DIR --implementations A:B [--context KIND] --progress 3
//
// JOB contains the cases without the judge's members. On the progress pipe the program writes "begin NAME" before a
// case and "end NAME" after it; its answers are files in DIR (case/exchange.hpp). One process answers all cases of its
// shard in order. If a case crashes it or takes too long, that case has no answer, and a new process continues with the
// rest.
//
// The program is not trusted: invalid messages on the pipe are ignored, and can only cost the program's own answers.
#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/implementations.hpp"
#include "judge/compare/answer.hpp"
#include "sandbox/sandbox.hpp"

namespace atelier::judge {

struct RunSettings {
  std::filesystem::path program;  ///< BIN/NN-name
  Implementations implementations;
  std::optional<Implementations> solution;  ///< the code for counted cases (judge/run/ask.hpp); none: implementations
  bool count = false;                       ///< also count each picture's cost, with --stats
  bool truth = false;                       ///< ask for the oracle's pictures, with --truth
  std::string context;                      ///< "osmesa", "egl" or "window"; empty: the default of the program
  int workers = 2;                          ///< processes at a time, 1..64; at most one per case is started
  std::optional<std::uint64_t> shuffle;     ///< seed of a random order of the cases; none: as listed
  std::chrono::milliseconds case_limit{10'000};   ///< wall-clock time of one case; then the program is killed
  std::chrono::milliseconds start_limit{10'000};  ///< wall-clock time until the first case begins
  /// After this many time-outs in all cases together no further case is asked; 0: no limit. One or two can have other
  /// reasons, such as a busy machine; after three the code itself surely hangs, and waiting for every other case would
  /// take minutes. Crashes do not count: restarting a program takes less than a tenth of a second.
  int max_time_outs = 3;
  int driver_threads = 0;                          ///< threads of llvmpipe, 0..32; 0 draws in the calling thread
  std::filesystem::path shader_cache;              ///< the driver's; created if missing; empty: none
  std::map<std::string, std::string> environment;  ///< additional variables, which override all others
  std::function<bool()> interrupted;               ///< called every few milliseconds; true stops the run; empty: never
  std::size_t output_limit = 8 << 10;              ///< bytes kept of the program's output during one case
  /// Where the student's program runs; null: with our own rights. `solution` is trusted and never runs in it.
  const sandbox::Sandbox* sandbox = nullptr;
  std::vector<std::filesystem::path> readable;  ///< in the sandbox, besides the program, its libraries and its code
};

/// Thrown if RunSettings::interrupted returned true: the programs were killed, and there are no answers.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Called in the calling thread when an answer arrives, with the case's index.
using OnAnswer = std::function<void(std::size_t, const Answer&)>;

/// One answer per case, in the order of `cases`, whatever order they were asked in:
/// - normally: the program reported the end, and its file could be read.
/// - missing: the program refused the case, left no readable file, or exited during the case or before any; `error`
///   says which. If it exits with an error before its first case, every answer has its message.
/// - crashed: a signal ended the program during this case or before any, or the student's code threw an exception;
///   `error` says which. After an exception the program continues with the next case.
/// - timeout: a limit ended the program, or the case was not asked because of settings.max_time_outs; `error` says
///   which. Throws Error if a setting is out of range, a name appears twice, or the program cannot be started;
///   Interrupted if settings.interrupted returns true.
std::vector<Answer> run_cases(const RunSettings& settings, const std::vector<Case>& cases,
                              const OnAnswer& on_answer = {});

/// Whether an environment variable affects the driver, the loader or the locale: LP_*, GALLIUM_*, GALLIVM_*, MESA_*,
/// LIBGL_*, LD_*, LC_*.
bool affects_driver(const std::string& variable);

/// The environment of a step program: ours without the variables above, plus fixed values for the driver. So the
/// pictures do not depend on who runs the judge. In a sandbox nothing is ours, and the driver has no cache.
std::map<std::string, std::string> program_environment(const RunSettings& settings);

/// The order in which `count` cases are asked: as listed, or shuffled with a seed, the same on every machine.
std::vector<std::size_t> case_order(std::size_t count, std::optional<std::uint64_t> seed);

}  // namespace atelier::judge
