#include "cli/search_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <system_error>

#include "base/error.hpp"
#include "cli/student/standing.hpp"
#include "judge/run/source_file.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

/// Whether the last full check passed every case of the step, and the files have not changed since.
bool has_passed(const ProjectFolders& folders, const CourseStep& step) {
  const Standing standing = standing_of(folders, step, read_progress(folders.progress()));
  return standing.passed && !standing.changed;
}

Owner choose_owner(const ProjectFolders& folders, const CourseStep& earlier, const std::string& asked) {
  if (asked == "mine") return Owner::mine;
  const bool has_solution = is_there(folders, earlier.name, Owner::solution);
  if (asked == "solution" && !has_solution)
    throw Error(fmt::format("--earlier solution: this copy of the course has no solution of {} that runs here; {}",
                            earlier.name, "leave the option out, or use --earlier mine"));
  return has_solution && (asked == "solution" || !has_passed(folders, earlier)) ? Owner::solution : Owner::mine;
}

/// Whether a library is for processors like this one, as the ELF headers say.
bool runs_here(const fs::path& library) {
  const auto processor_of = [](const fs::path& file) {
    std::string header(20, '\0');
    std::ifstream(file, std::ios::binary).read(header.data(), std::streamsize(header.size()));
    return header.substr(0, 7) + header.substr(18);  // magic number, class, byte order, version; e_machine
  };
  return processor_of(library) == processor_of("/proc/self/exe");
}

std::set<std::string> steps_in(const fs::path& folder) {
  std::set<std::string> names;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing))
    if (entry.is_directory()) names.insert(entry.path().filename().string());
  return names;
}

}  // namespace

std::string to_string(Owner owner) {
  return owner == Owner::mine ? "yours" : "solution";
}

bool is_there(const ProjectFolders& folders, const std::string& step, Owner owner) {
  const fs::path sources = code_of(folders, owner).sources / step;
  const fs::path carried = sources / "libstep.so";
  return fs::is_directory(sources) && (owner == Owner::mine || !fs::exists(carried) || runs_here(carried));
}

bool is_solution_readable(const ProjectFolders& folders, const CourseStep& step) {
  return std::all_of(step.files.begin(), step.files.end(), [&](const std::string& file) {
    return judge::why_unusable(folders.solutions() / step.name / file).empty();
  });
}

grade::Code code_of(const ProjectFolders& folders, Owner owner) {
  if (owner == Owner::mine) return {.sources = folders.steps(), .libraries = folders.own_implementations()};
  return {.sources = folders.solutions(), .libraries = folders.implementations() / "solutions"};
}

Owners choose_owners(const ProjectFolders& folders, const std::vector<CourseStep>& course, const CourseStep& step,
                     const std::string& asked) {
  if (!asked.empty() && asked != "mine" && asked != "solution")
    throw Error(fmt::format("--earlier {}: it takes mine or solution", asked));
  Owners owners;
  for (const std::string& name : step.uses) owners[name] = choose_owner(folders, resolve_step(course, name), asked);
  return owners;
}

Implementations search_path(const ProjectFolders& folders, const CourseStep& step, const grade::Code& code,
                            const Owners& earlier) {
  std::vector<Implementations::Root> roots;
  const auto add = [&](const grade::Code& from, const std::string& only) {
    for (const fs::path& folder : {from.libraries, from.sources})
      if (fs::is_directory(folder)) roots.push_back({folder, only});
  };
  roots.push_back({folders.steps(), step.name + "/given"});  // first, so that no other code can replace the given code
  add(code, step.name);
  for (const auto& [name, owner] : earlier) add(code_of(folders, owner), name);
  for (const Owner owner : {Owner::solution, Owner::mine})
    for (const std::string& other : steps_in(code_of(folders, owner).sources))
      if (other != step.name) add(code_of(folders, owner), other);
  for (const Implementations::Root& root : roots)
    if (root.folder.string().find(':') != std::string::npos)
      throw Error(
          fmt::format("{}: a folder with ':' in its path cannot be used; move or rename it", root.folder.string()));
  return Implementations(std::move(roots));
}

std::map<std::string, std::string> in_words(const Owners& earlier, const std::string& step,
                                            const std::string& own_words) {
  std::map<std::string, std::string> words;
  for (const auto& [name, owner] : earlier) words[name] = to_string(owner);
  words[step] = own_words;
  return words;
}

}  // namespace atelier
