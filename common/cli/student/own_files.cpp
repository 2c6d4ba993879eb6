#include "cli/student/own_files.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/file.hpp"
#include "judge/run/source_file.hpp"

namespace atelier {

OwnFiles prepare_own_files(const ProjectFolders& folders, const std::vector<CourseStep>& course, const CourseStep& step,
                           const grade::Code& mine, const std::string& earlier) {
  const judge::StepFlags flags = judge::read_step_flags(folders.step_flags());
  OwnFiles own;
  own.earlier = choose_owners(folders, course, step, earlier);
  for (const auto& [name, owner] : own.earlier) {
    if (owner != Owner::mine) continue;
    const grade::Code before = code_of(folders, Owner::mine);
    const judge::Built built = judge::build_step(flags, name, before.sources / name, before.libraries);
    if (!built.ok)
      throw Error(fmt::format("your own {} does not build{}:\n{}", name,
                              is_there(folders, name, Owner::solution) ? " (--earlier solution avoids it)" : "",
                              built.log));
  }
  own.built = judge::build_step(flags, step.name, mine.sources / step.name, mine.libraries);
  own.path = search_path(folders, step, mine, own.earlier);
  return own;
}

grade::PackedFiles read_own_files(const ProjectFolders& folders, const CourseStep& step) {
  namespace fs = std::filesystem;
  grade::PackedFiles files;
  for (const std::string& file : step.files) {
    const fs::path path = folders.steps() / step.name / file;
    if (const std::string why = judge::why_unusable(path); !why.empty())
      throw Error(fmt::format("{}: {}; it must be a regular file of yours; nothing was packed", path.string(), why));
    files[step.name + "/" + file].bytes = read_file(path, judge::source_limit);
  }
  return files;
}

}  // namespace atelier
