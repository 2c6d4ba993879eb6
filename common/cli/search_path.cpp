#include "cli/search_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <system_error>

#include "base/error.hpp"
#include "cli/student/standing.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

/// Whether the last full check passed every case of the step, and the files have not changed since.
bool has_passed(const ProjectFolders& folders, const CourseStep& step) {
  const Standing standing = standing_of(folders, step, read_progress(folders.progress()));
  return standing.passed && !standing.changed;
}

Owner choose_owner(const ProjectFolders& folders, const CourseStep& earlier, const std::string& asked) {
  const Owner wanted =
      asked == "mine" || (asked.empty() && has_passed(folders, earlier)) ? Owner::mine : Owner::solution;
  const Owner other = wanted == Owner::mine ? Owner::solution : Owner::mine;
  return is_there(folders, earlier.name, wanted) ? wanted : other;
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
  return fs::is_directory(code_of(folders, owner).sources / step);
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
