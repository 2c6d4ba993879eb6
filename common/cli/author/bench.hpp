// The measurements of ./atelier bench: whole commands, and their parts.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.hpp"
#include "cli/layout.hpp"
#include "measure/baseline.hpp"
#include "measure/ratios.hpp"

namespace atelier {

/// One measured figure: the median of its runs.
struct Figure {
  std::string name;    ///< "edit to verdict, GLSL"
  std::string detail;  ///< conditions: "10 cases of 256x256, cold shader cache"
  double seconds = 0;  ///< median
  double least = 0, most = 0;
  double limit = 0;  ///< the project's target, seconds; 0: none
};

/// Times `action` `repeats` times; calls `prepare` before each, untimed.
Figure time_runs(std::string name, std::string detail, int repeats, const std::function<void()>& action,
                 const std::function<void()>& prepare = {});

/// A student's usual commands on one step: an edit of each kind of file, the launcher, the program's start, the shader
/// compiler with and without its optimiser.
std::vector<Figure> bench_commands(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                                   const CourseStep& step, int repeats);

/// The parts within this process: contexts and comparisons.
std::vector<Figure> bench_parts(int repeats);

/// Grades a made-up class of `count` submissions of four steps, in a sandbox and without, and prints where the time
/// went.
void bench_class(const ProjectFolders& folders, const std::vector<CourseStep>& course, int count);

inline constexpr int timed_frames = 15;  ///< per picture and round

/// The step's program with the solutions, and with shaders that the driver optimises.
measure::Program solved_program(const ProjectFolders& folders, const CourseStep& step);

/// Frame times of a step compared with a baseline program, in `repeats` rounds.
struct BaselineTable {
  measure::BaselinePlan plan;
  measure::BaselineComparison compared;
};
/// None if the step has no baseline.json, as in a release. Throws Error if the baseline's program is not built.
std::optional<BaselineTable> bench_baseline(const ProjectFolders& folders, const CourseStep& step, int repeats);
void print_baseline(const BaselineTable& table);
nlohmann::ordered_json baseline_as_json(const BaselineTable& table);

/// Frame times of pictures of a step compared with one another, in `repeats` rounds.
struct RatioTable {
  measure::RatioPlan plan;
  std::vector<measure::MeasuredRatio> measured;  ///< parallel to the plan's rows
};
/// None if the step has no ratios.json, as in a release.
std::optional<RatioTable> bench_ratios(const ProjectFolders& folders, const CourseStep& step, int repeats);
void print_ratios(const RatioTable& table);
nlohmann::ordered_json ratios_as_json(const RatioTable& table);

/// Work of a step beside that of another package, timed in one process (tests/peers).
struct PeerRow {
  std::string work, peer;
  std::string missing;                    ///< the package that must be installed first; the times are 0 then
  double ours = 0, theirs = 0;            ///< seconds: medians over the rounds
  double ratio = 0, least = 0, most = 0;  ///< theirs / ours, per round: median and range
  double aim = 0;                         ///< 0: none
};
/// Runs the step's program of tests/peers with `repeats` rounds. Throws Error if it is not built, fails, or takes
/// longer than two minutes and one more for each round.
std::vector<PeerRow> bench_peers(const ProjectFolders& folders, const CourseStep& step, int repeats);
/// What such a program writes (tests/peers/peers.hpp) after this many rounds; every error message begins with `where`.
/// Throws Error naming the member and what is allowed.
std::vector<PeerRow> parse_peers(std::string_view text, int rounds, const std::string& where);
void print_peers(const std::vector<PeerRow>& rows);
nlohmann::ordered_json peers_as_json(const std::vector<PeerRow>& rows);

}  // namespace atelier
