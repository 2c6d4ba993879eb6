// ./atelier skeleton: makes the students' files out of the solutions.
#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/sha256.hpp"
#include "cli/author/marked_text.hpp"
#include "cli/author/skeleton_record.hpp"
#include "cli/author/step_rules.hpp"
#include "cli/commands.hpp"
#include "cli/layout.hpp"

namespace atelier {
namespace {

/// One file of a student, as it should be.
struct Skeleton {
  std::string name;  ///< "02-blinn-phong/blinn_phong.cpp"
  std::string text;
  bool current = false;         ///< steps/ and the record have just this
  bool somebodys_work = false;  ///< steps/ has a text that no run of this command has written
};

std::vector<Skeleton> make_skeletons(const ProjectFolders& folders, const std::vector<CourseStep>& steps,
                                     const SkeletonRecord& record) {
  std::vector<Skeleton> skeletons;
  for (const CourseStep& step : steps)
    for (const std::string& file : step.files) {
      Skeleton skeleton{.name = step.name + "/" + file};
      skeleton.text =
          cut_skeleton(read_file(folders.solutions() / skeleton.name), "solutions/" + skeleton.name, step.name);
      const SkeletonState state = skeleton_state(folders.steps(), record, skeleton.name);
      const bool same = state != SkeletonState::missing && read_file(folders.steps() / skeleton.name) == skeleton.text;
      skeleton.current = same && state == SkeletonState::untouched;
      skeleton.somebodys_work = !same && state == SkeletonState::edited;
      skeletons.push_back(std::move(skeleton));
    }
  return skeletons;
}

int check(const std::vector<Skeleton>& skeletons) {
  int stale = 0;
  for (const Skeleton& skeleton : skeletons)
    if (!skeleton.current) {
      fmt::print("steps/{} is not the skeleton of solutions/{}\n", skeleton.name, skeleton.name);
      ++stale;
    }
  if (stale == 0) {
    fmt::print("{} skeletons are up to date\n", skeletons.size());
    return exit_ok;
  }
  fmt::print("{} of {} skeletons are out of date: run ./atelier skeleton\n", stale, skeletons.size());
  return exit_failed;
}

/// Says what the steps' tests lack, and is the exit status of that.
int tell_lacks(const ProjectFolders& folders, const std::vector<CourseStep>& steps) {
  Lacks lacks;
  for (const CourseStep& step : steps)
    for (const std::string& lack : lacks_of_tests(folders, step)) lacks.push_back(lack);
  fmt::print("{}", in_lines(lacks));
  return lacks.empty() ? exit_ok : exit_failed;
}

void refuse_to_overwrite(const std::vector<Skeleton>& skeletons) {
  std::vector<std::string> edited;
  for (const Skeleton& skeleton : skeletons)
    if (skeleton.somebodys_work) edited.push_back("steps/" + skeleton.name);
  if (!edited.empty())
    throw Error(fmt::format("somebody has worked on {}: nothing was written; --force overwrites it", join(edited)));
}

}  // namespace

int run_skeleton(const SkeletonOptions& options) {
  const ProjectFolders folders = project_folders();
  const auto steps = resolve_steps(read_course(folders.step_flags()), options.steps);
  SkeletonRecord record = read_skeleton_record(folders.steps());
  const auto skeletons = make_skeletons(folders, steps, record);
  if (options.check) return std::max(check(skeletons), tell_lacks(folders, steps));

  if (!options.force) refuse_to_overwrite(skeletons);
  for (const Skeleton& skeleton : skeletons) {
    if (skeleton.current) continue;
    write_file(folders.steps() / skeleton.name, skeleton.text);
    record[skeleton.name] = sha256(skeleton.text);
    fmt::print("steps/{}\n", skeleton.name);
  }
  write_skeleton_record(folders.steps(), record);
  fmt::print("{} skeletons are up to date\n", skeletons.size());
  return tell_lacks(folders, steps);
}

}  // namespace atelier
