// What ./atelier bench measures, by where the time goes: whole commands, and the parts inside them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/layout.hpp"

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
Figure measure(std::string name, std::string detail, int repeats, const std::function<void()>& action,
               const std::function<void()>& prepare = {});

/// The commands of a student's loop on one step: an edit of each kind of file, the launcher, the program's start, the
/// shader compiler with and without its optimiser.
std::vector<Figure> bench_commands(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                                   const CourseStep& step, int repeats);

/// The parts within this process: contexts and comparisons.
std::vector<Figure> bench_parts(int repeats);

}  // namespace atelier
