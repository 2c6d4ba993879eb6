// ./atelier release: makes the students' version of one step, several steps or the course, as a folder or a ZIP.
#include <fmt/format.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "cli/commands.hpp"
#include "cli/grader/release_contents.hpp"
#include "cli/layout.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

Earlier earlier_named(const std::string& name) {
  if (name == "none") return Earlier::none;
  if (name == "source") return Earlier::source;
  if (name == "library") return Earlier::library;
  throw Error(fmt::format("--earlier {}: it takes none, source or library", name));
}

std::vector<CourseStep> steps_named(const std::vector<CourseStep>& course, const std::vector<std::string>& names) {
  if (names.empty()) throw Error("release: name a step, as in ./atelier release 01 --out FOLDER, or all");
  if (names != std::vector<std::string>{"all"}) return resolve_steps(course, names);
  return course;
}

void refuse_to_overwrite(const fs::path& folder) {
  if (!fs::exists(fs::symlink_status(folder))) return;
  if (!fs::is_directory(folder)) throw Error(fmt::format("--out {}: is a file; name a new folder", folder.string()));
  if (!fs::is_empty(folder))
    throw Error(fmt::format("--out {}: is not empty; name a new folder, or a file that ends in .zip", folder.string()));
}

/// Atomic: writes a temporary folder and renames it.
void write_folder(const fs::path& folder, const grade::PackedFiles& files) {
  const fs::path absolute = fs::absolute(folder).lexically_normal();
  const fs::path target = absolute.has_filename() ? absolute : absolute.parent_path();  // "out/" is "out"
  const fs::path part = target.parent_path() / fmt::format(".atelier-{}.part", ::getpid());
  try {
    fs::remove_all(part);  // left by a killed run
    for (const auto& [path, file] : files) {
      write_file(part / path, file.bytes);
      if (file.executable)
        fs::permissions(part / path, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                        fs::perm_options::add);
    }
    fs::rename(part, target);
  } catch (const std::exception& error) {
    std::error_code ignored;
    fs::remove_all(part, ignored);
    throw Error(fmt::format("--out {}: {}", folder.string(), error.what()));
  }
}

void print_summary(const Release& release, const std::vector<CourseStep>& steps, Earlier earlier, const fs::path& out) {
  std::size_t bytes = 0;
  for (const auto& [path, file] : release.files) bytes += file.bytes.size();
  std::vector<std::string> names;
  for (const CourseStep& step : steps) names.push_back(step.name);
  fmt::print("Released: {} ({} files, {} bytes)\n", out.string(), release.files.size(), bytes);
  fmt::print("  steps     {}{}\n", join(names),
             release.earlier.empty() ? "" : fmt::format("; and {}, which they use", join(release.earlier)));
  fmt::print("  cases     {}, worth {:g} points\n", release.cases, release.points);
  if (!release.carried.empty())
    fmt::print("  stand-in  {}: their solutions, {}, for students who have not passed them\n", join(release.carried),
               earlier == Earlier::source ? "as text" : "compiled (--earlier none leaves them out)");
  fmt::print("  left out  {} files of solutions, {} patches, {} hidden cases worth {:g} points\n", release.solutions,
             release.patches, release.hidden, release.hidden_points);
  if (!release.untracked.empty())
    fmt::print("  left out  {} files not tracked by git: {}\n", release.untracked.size(), join(release.untracked));
}

}  // namespace

int run_release(const ReleaseOptions& options) {
  const Earlier earlier = earlier_named(options.earlier);
  const ProjectFolders folders = project_folders();
  const auto course = read_course(folders.step_flags());
  const auto steps = steps_named(course, options.steps);
  const bool zip = options.out.extension() == ".zip";
  if (!zip) refuse_to_overwrite(options.out);

  const Release release = make_release(folders, course, steps, earlier);
  if (earlier == Earlier::source && release.earlier.empty())
    throw Error("--earlier source: the steps to release use no step that is not released too; leave it out");
  if (zip)
    write_file(options.out, grade::make_zip(release.files));
  else
    write_folder(options.out, release.files);
  print_summary(release, steps, earlier, options.out);
  return exit_ok;
}

}  // namespace atelier
