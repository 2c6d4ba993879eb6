// ./atelier submit: packs a student's files of a step for `grade`.
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/file.hpp"
#include "cli/author/skeleton_record.hpp"
#include "cli/commands.hpp"
#include "cli/layout.hpp"
#include "cli/student/own_files.hpp"
#include "cli/student/standing.hpp"
#include "judge/report/report_words.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

std::string state_in_words(SkeletonState state) {
  return state == SkeletonState::untouched ? "still the untouched skeleton" : to_string(state);
}

std::string check_in_words(const ProjectFolders& folders, const CourseStep& step) {
  try {
    const Standing standing = standing_of(folders, step, read_progress(folders.progress()));
    if (!standing.checked || standing.changed)
      return fmt::format("These files have not been checked in full: ./atelier check {}", step.number());
    return fmt::format("The last check passed {} of {} cases and gave {} / {} points.", standing.cases_passed,
                       standing.cases, judge::points_text(standing.score), judge::points_text(standing.max_score));
  } catch (const Error&) {  // an invalid record must not prevent a submission
    return "The result of the last check is unknown.";
  }
}

}  // namespace

int run_submit(const SubmitOptions& options) {
  const ProjectFolders folders = project_folders();
  const CourseStep step = resolve_step(read_course(folders.step_flags()), options.step);
  const fs::path out = options.out.empty() ? folders.out() / "submit" / (step.name + ".zip") : options.out;
  if (out.extension() != ".zip") throw Error(fmt::format("--out {}: must be a file that ends in .zip", out.string()));

  const grade::PackedFiles files = read_own_files(folders, step);
  const std::string archive = grade::make_zip(files);
  write_file(out, archive);

  const SkeletonRecord record = read_skeleton_record(folders.steps());
  for (const auto& [name, file] : files)
    fmt::print("  {:<40} {:>7} bytes  {}\n", name, file.bytes.size(),
               state_in_words(skeleton_state(folders.steps(), record, name)));
  fmt::print("{}\nPacked: {} ({} bytes)\n", check_in_words(folders, step), out.string(), archive.size());
  return exit_ok;
}

}  // namespace atelier
