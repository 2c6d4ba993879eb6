// ./atelier skeleton: generates the students' files from the solutions.
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

/// The expected content of one student file.
struct Skeleton {
  std::string name;  ///< "02-blinn-phong/blinn_phong.cpp"
  std::string text;
  bool current = false;  ///< steps/ and the record match it
  bool edited = false;   ///< steps/ has a file that this command has not written
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
      skeleton.edited = !same && state == SkeletonState::edited;
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

/// Prints the problems of the steps' tests; returns the exit status.
int print_problems(const ProjectFolders& folders, const std::vector<CourseStep>& steps) {
  Problems problems;
  for (const CourseStep& step : steps)
    for (const std::string& problem : problems_of_tests(folders, step)) problems.push_back(problem);
  fmt::print("{}", in_lines(problems));
  return problems.empty() ? exit_ok : exit_failed;
}

void refuse_to_overwrite(const std::vector<Skeleton>& skeletons) {
  std::vector<std::string> edited;
  for (const Skeleton& skeleton : skeletons)
    if (skeleton.edited) edited.push_back("steps/" + skeleton.name);
  if (!edited.empty())
    throw Error(fmt::format("{} has been edited: nothing was written; --force overwrites it", join(edited)));
}

}  // namespace

int run_skeleton(const SkeletonOptions& options) {
  const ProjectFolders folders = project_folders();
  const auto steps = resolve_steps(read_course(folders.step_flags()), options.steps);
  SkeletonRecord record = read_skeleton_record(folders.steps());
  const auto skeletons = make_skeletons(folders, steps, record);
  if (options.check) return std::max(check(skeletons), print_problems(folders, steps));

  if (!options.force) refuse_to_overwrite(skeletons);
  for (const Skeleton& skeleton : skeletons) {
    if (skeleton.current) continue;
    write_file(folders.steps() / skeleton.name, skeleton.text);
    record[skeleton.name] = sha256(skeleton.text);
    fmt::print("steps/{}\n", skeleton.name);
  }
  write_skeleton_record(folders.steps(), record);
  fmt::print("{} skeletons are up to date\n", skeletons.size());
  return print_problems(folders, steps);
}

}  // namespace atelier
