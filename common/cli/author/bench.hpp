// What ./atelier bench measures, by where the time goes: whole commands, and the parts inside them.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/layout.hpp"
#include "measure/baseline.hpp"

namespace atelier {

/// One measured figure: the median of its runs.
struct Figure {
  std::string name;    ///< "edit to verdict, GLSL"
  std::string detail;  ///< of what: "10 cases of 256x256, cold shader cache"
  double seconds = 0;  ///< median
  double least = 0, most = 0;
  double limit = 0;  ///< what the project aims at, in seconds; 0: nothing
};

/// Runs `action` `repeats` times, after `prepare` each time, whose own time does not count.
Figure time_runs(std::string name, std::string detail, int repeats, const std::function<void()>& action,
                 const std::function<void()>& prepare = {});

/// The commands of a student's loop on one step: an edit of each kind of file, the launcher, the program's start, the
/// shader compiler with and without its optimiser.
std::vector<Figure> bench_commands(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                                   const CourseStep& step, int repeats);

/// The parts within this process: contexts and comparisons.
std::vector<Figure> bench_parts(int repeats);

/// A step's frames beside those of a baseline program, in `repeats` rounds.
struct BaselineTable {
  measure::BaselinePlan plan;
  measure::BaselineComparison compared;
};
/// None where the step has no baseline.json, as in a release. Throws Error where the baseline's program is not built.
std::optional<BaselineTable> bench_baseline(const ProjectFolders& folders, const CourseStep& step, int repeats);
void print_baseline(const BaselineTable& table);
nlohmann::ordered_json baseline_as_json(const BaselineTable& table);

}  // namespace atelier
