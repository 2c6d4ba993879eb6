#include "cli/student/unfinished.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "cli/student/reset_file.hpp"
#include "cli/student/standing.hpp"

namespace atelier {
namespace {

bool is_untouched(const ProjectFolders& folders, const CourseStep& step) {
  try {
    return std::all_of(step.files.begin(), step.files.end(), [&](const std::string& file) {
      return is_pristine(folders, {step, file});
    });
  } catch (const Error&) {  // its skeleton is not here
    return false;
  }
}

}  // namespace

std::map<std::string, std::string> unfinished_steps(const ProjectFolders& folders,
                                                    const std::vector<CourseStep>& course, const Owners& owners) {
  std::map<std::string, std::string> unfinished;
  const ProgressRecord record = read_progress(folders.progress());
  for (const auto& [name, owner] : owners) {
    if (owner != Owner::mine) continue;
    const CourseStep& step = resolve_step(course, name);
    const Standing standing = standing_of(folders, step, record);
    if (standing.passed && !standing.changed) continue;
    unfinished[name] = is_untouched(folders, step) ? "untouched"
                       : standing.cases == 0       ? "without cases here"
                                                   : in_words(standing);
  }
  return unfinished;
}

std::string about_unfinished(const ProjectFolders& folders, const CourseStep& step,
                             const std::map<std::string, std::string>& unfinished) {
  if (unfinished.empty()) return {};
  std::vector<std::string> states;
  for (const auto& [name, state] : unfinished) states.push_back(fmt::format("{} ({})", name, state));
  const std::string& first = unfinished.begin()->first;
  const std::string number = first.substr(0, first.find('-'));
  std::string text = fmt::format(
      "{} uses earlier files of yours that do not pass in full: {}. What they get wrong costs points here too, so "
      "these points cannot judge your {} alone. ",
      step.name, join(states), step.name);
  if (is_there(folders, first, Owner::solution)) return text + "Leave out --earlier mine to use the solution instead.";
  if (std::filesystem::exists(folders.case_file(first))) return text + fmt::format("First: ./atelier check {}", number);
  return text +
         fmt::format("First finish {0}, with a release that has its cases, and copy your files to steps/{0}.", first);
}

}  // namespace atelier
