#include "cli/student/after_pass.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/search_path.hpp"
#include "cli/student/handout.hpp"

namespace atelier {

std::string after_pass(const ProjectFolders& folders, const std::vector<Standing>& standings, const std::string& step) {
  const auto found = std::find_if(standings.begin(), standings.end(),
                                  [&](const Standing& standing) { return standing.step.name == step; });
  if (found == standings.end() || !found->passed) return {};

  std::string text = fmt::format("\n{} has passed in full.\n", step);
  if (const std::string reading = further_reading_of(folders, found->step); !reading.empty())
    text += fmt::format("  read on     {}\n", reading);
  if (is_solution_readable(folders, found->step))
    text +=
        fmt::format("  compare     ./atelier compare {}: your functions and the solution's\n", found->step.number());
  if (const Standing* next = next_step(standings))
    text += fmt::format("  next        ./atelier next: {}  {}\n", next->step.name, next->step.title);
  else
    text += "  next        nothing: every step has passed\n";
  return text;
}

}  // namespace atelier
