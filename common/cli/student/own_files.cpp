#include "cli/student/own_files.hpp"

#include <fmt/format.h>

#include <chrono>
#include <system_error>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/sha256.hpp"
#include "judge/run/source_file.hpp"

namespace atelier {

grade::Code own_code(const ProjectFolders& folders, const std::filesystem::path& sources) {
  namespace fs = std::filesystem;
  if (sources.empty()) return code_of(folders, Owner::mine);
  const fs::path folder = fs::weakly_canonical(sources), all = folders.implementations() / "elsewhere";
  const fs::path kept = all / sha256(folder.string()).substr(0, 16);
  std::error_code none;
  for (const auto& other : fs::directory_iterator(all, none))
    if (other.path() != kept && fs::file_time_type::clock::now() - other.last_write_time(none) > std::chrono::hours(24))
      fs::remove_all(other.path(), none);
  return {.sources = folder, .libraries = kept};
}

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

judge::RunSettings run_settings(const ProjectFolders& folders, const CourseStep& step, Implementations path,
                                const std::string& context) {
  judge::RunSettings settings;
  settings.program = folders.program(step.name);
  settings.implementations = std::move(path);
  if (is_there(folders, step.name, Owner::solution))
    settings.solution = search_path(folders, step, code_of(folders, Owner::solution), {});
  settings.context = context;
  settings.shader_cache = folders.shader_cache();
  return settings;
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
