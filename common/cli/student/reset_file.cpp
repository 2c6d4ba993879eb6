#include "cli/student/reset_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/sealed.hpp"
#include "cli/author/marked_text.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

bool has(const CourseStep& step, const std::string& file) {
  return std::find(step.files.begin(), step.files.end(), file) != step.files.end();
}

std::vector<std::string> files_of(const std::vector<CourseStep>& steps) {
  std::vector<std::string> names;
  for (const CourseStep& step : steps)
    for (const std::string& file : step.files) names.push_back(step.name + "/" + file);
  return names;
}

[[noreturn]] void refuse(const std::string& text, const std::vector<CourseStep>& steps) {
  throw Error(fmt::format("{}: not a student's file; these are {}", text, join(files_of(steps))));
}

}  // namespace

StudentFile find_student_file(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                              const std::string& text) {
  fs::path path = fs::path(text).lexically_normal();
  if (path.is_absolute()) path = path.lexically_relative(folders.own());
  if (path.begin() != path.end() && *path.begin() == "steps") path = path.lexically_relative("steps");
  const bool step_is_named = path.has_parent_path();
  const std::string name = step_is_named ? path.lexically_relative(*path.begin()).string() : path.string();

  if (step_is_named) {
    const CourseStep& step = resolve_step(course, path.begin()->string());
    if (!has(step, name)) refuse(text, {step});
    return {step, name};
  }
  std::vector<CourseStep> owners;
  for (const CourseStep& step : course)
    if (has(step, name)) owners.push_back(step);
  if (owners.empty()) refuse(text, course);
  if (owners.size() > 1) {
    std::vector<std::string> names;
    for (const CourseStep& step : owners) names.push_back(step.name + "/" + name);
    throw Error(fmt::format("{}: ambiguous; choose {}", text, join(names, " or ")));
  }
  return {owners.front(), name};
}

std::string pristine_text(const ProjectFolders& folders, const StudentFile& file) {
  for (const fs::path& given : {folders.given(), folders.skeletons()})
    if (const fs::path path = given / file.below_steps(); fs::is_regular_file(path)) return read_file(path);
  const fs::path solution = folders.solutions() / file.below_steps();
  if (fs::is_regular_file(solution) && !is_sealed(read_file(solution)))
    return cut_skeleton(read_file(solution), "solutions/" + file.below_steps().string(), file.step.name);
  throw Error(
      fmt::format("{0}: its skeleton is not here (looked for .given/{0}, skeletons/{0} and solutions/{0}); copy the "
                  "file from the course's archive again",
                  file.below_steps().string()));
}

bool is_pristine(const ProjectFolders& folders, const StudentFile& file) {
  const fs::path path = folders.steps() / file.below_steps();
  return fs::exists(path) && read_file(path) == pristine_text(folders, file);
}

Reset reset_file(const ProjectFolders& folders, const StudentFile& file) {
  Reset reset;
  if (is_pristine(folders, file)) return reset;
  const std::string pristine = pristine_text(folders, file);
  const fs::path path = folders.steps() / file.below_steps();
  if (fs::exists(path)) {
    reset.copy = free_path(path, ".before-reset");
    write_file(reset.copy, read_file(path));
  }
  write_file(path, pristine);
  reset.changed = true;
  return reset;
}

}  // namespace atelier
