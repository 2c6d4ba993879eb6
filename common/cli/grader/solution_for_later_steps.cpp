#include "cli/grader/solution_for_later_steps.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "base/sealed.hpp"
#include "cli/author/marked_text.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

/// Without debug information, which has file names of this machine and refers to source lines.
std::string stripped_library(const ProjectFolders& folders, const CourseStep& step) {
  const fs::path library = folders.implementations() / "solutions" / step.name / "libstep.so";
  if (!fs::exists(library))
    throw Error(fmt::format("{}: is missing; build the project, then repeat this", library.string()));
  const TemporaryFolder scratch("atelier-strip");
  const fs::path stripped = scratch.path() / "libstep.so";
  const Finished strip =
      run_process({.arguments = {"strip", "--strip-unneeded", "-o", stripped.string(), library.string()}});
  if (!strip.ok()) throw Error(fmt::format("{}: cannot be stripped: {}", library.string(), strip.output));
  return read_file(stripped);
}

}  // namespace

std::map<std::string, std::string> solution_for_later_steps(const ProjectFolders& folders, const CourseStep& step) {
  const fs::path solution = folders.solutions() / step.name, carried = solution / "libstep.so";
  std::map<std::string, std::string> files;
  for (const std::string& file : step.files) {
    if (file.ends_with(".cpp")) {
      files["libstep.so"] = fs::exists(carried) ? read_file(carried) : stripped_library(folders, step);
    } else if (file.ends_with(".glsl")) {
      const std::string text = read_file(solution / file);
      files[file] = is_sealed(text) ? text : seal(finished_text(text, "solutions/" + step.name + "/" + file));
    }
  }
  return files;
}

}  // namespace atelier
