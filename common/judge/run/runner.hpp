// Asks a step program for its cases, and comes back with an answer for each, whatever the program does.
//
//   PROGRAM --cases JOB --out DIR --implementations A:B [--context KIND] --progress 3
//
// JOB holds what is asked, never what is thought of the answer. On the progress pipe the program writes "begin NAME"
// before a case and "end NAME" behind it; its answers are files in DIR (case/exchange.hpp). One process answers all
// cases of its share in order. A case that crashes it or lasts too long is given up, and a new process goes on with the
// rest.
//
// Nothing that the program says is believed: a lie on the pipe is passed over, and costs the liar its own answer.
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

namespace atelier::judge {

struct RunSettings {
  std::filesystem::path program;  ///< BIN/NN-name
  Implementations implementations;
  std::optional<Implementations> solution;  ///< whose code draws what is counted (judge/run/ask.hpp); none: the same
  bool count = false;                       ///< also ask what each picture has cost, by --stats
  bool truth = false;                       ///< ask for the oracle's pictures, by --truth
  std::string context;                      ///< "osmesa", "egl" or "window"; empty: what make_headless_context() takes
  int workers = 2;                          ///< processes at a time, 1..64; no more than there are cases are started
  std::optional<std::uint64_t> shuffle;     ///< a seed: ask in an order drawn from it, not as listed
  std::chrono::milliseconds case_limit{10'000};   ///< wall clock of one case; then the program is killed
  std::chrono::milliseconds start_limit{10'000};  ///< wall clock until the first case begins
  /// Time-outs, in all cases together, after which no further case is asked; 0: no such limit. One may be bad luck on a
  /// busy machine and a second one the same slow function; with three at the full limit of a case each, what hangs is
  /// the code, and the other cases would only make everybody wait: seven minutes for 41 cases. Crashes are not counted:
  /// starting a program anew costs less than a tenth of a second.
  int most_time_outs = 3;
  int driver_threads = 0;                          ///< llvmpipe's own threads, 0..32: 0 draws in the calling thread
  std::filesystem::path shader_cache;              ///< the driver's, made where missing; empty: none
  std::map<std::string, std::string> environment;  ///< variables set beside, and last of all
  std::function<bool()> interrupted;               ///< asked every few milliseconds: whether to stop; empty: never
  std::size_t output_limit = 8 << 10;              ///< bytes kept of what the program prints around one case
};

/// Thrown where RunSettings::interrupted said so: the programs have been ended, and there are no answers.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Called in the calling thread as each answer comes in, with the case's place in the list.
using OnAnswer = std::function<void(std::size_t, const Answer&)>;

/// One answer a case, in the order of `cases`, whatever order they were asked in:
/// - normally: "end" came, and the file that the case asks for could be read.
/// - missing: the program refused the case, left no readable file, exited by itself in the middle, or never began:
/// `error`
///   says which. A program that exits with status 2 before its first case has its sentence in the answer of every case.
/// - crashed, timeout: a signal or a limit ended the program in this case, or before it began any. What the student's
///   code threw is a crash of this case too, and `error` says what it was; the program goes on with the next.
/// - timeout too where the case was not asked any more, after settings.most_time_outs; `error` says so.
/// Throws Error where a setting is out of range, a name stands twice, or the program cannot be started at all;
/// Interrupted where `settings` says so.
std::vector<Answer> run_cases(const RunSettings& settings, const std::vector<Case>& cases,
                              const OnAnswer& on_answer = {});

/// Whether a variable of the environment changes what a driver draws or says of itself.
bool bends_the_driver(const std::string& variable);

/// The environment that a step program gets: ours without what bends a driver or the loader (LP_*, GALLIUM_*,
/// GALLIVM_*, MESA_*, LIBGL_*, LD_*, LC_*), and then set in full: the same picture comes out whoever runs the judge.
std::map<std::string, std::string> program_environment(const RunSettings& settings);

/// The order in which `count` cases are asked: as listed, or drawn from a seed, the same on every machine.
std::vector<std::size_t> asking_order(std::size_t count, std::optional<std::uint64_t> seed);

}  // namespace atelier::judge
