#include "cli/search_path.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/file.hpp"
#include "case/strict_json.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using strict_json::Json;

/// Whether the report of the last check is about every case, gives all points, and is younger than the step's files.
bool has_passed(const ProjectFolders& folders, const CourseStep& step) {
  const fs::path report = folders.out() / "check" / step.name / "results.json";
  std::error_code error;
  const auto judged = fs::last_write_time(report, error);
  if (error) return false;
  for (const std::string& file : step.files)
    if (const auto written = fs::last_write_time(folders.steps() / step.name / file, error); error || written > judged)
      return false;
  try {
    const Json results = strict_json::parse(read_file(report), report.string());
    const auto& cases = results.at("steps").at(0).at("cases");
    for (const Json& c : cases)
      if (c.at("status") != "passed") return false;
    return cases.size() == judge::read_case_file(folders.case_file(step.name)).cases.size();
  } catch (const std::exception&) {
    return false;  // a report that cannot be read proves nothing
  }
}

bool is_there(const ProjectFolders& folders, const std::string& step, Owner owner) {
  return fs::is_directory(code_of(folders, owner).sources / step);
}

Owner choose_owner(const ProjectFolders& folders, const CourseStep& earlier, const std::string& asked) {
  const Owner wanted =
      asked == "mine" || (asked.empty() && has_passed(folders, earlier)) ? Owner::mine : Owner::solution;
  const Owner other = wanted == Owner::mine ? Owner::solution : Owner::mine;
  return is_there(folders, earlier.name, wanted) ? wanted : other;
}

}  // namespace

std::string to_string(Owner owner) {
  return owner == Owner::mine ? "yours" : "solution";
}

grade::Code code_of(const ProjectFolders& folders, Owner owner) {
  if (owner == Owner::mine) return {.sources = folders.steps(), .libraries = folders.implementations() / "mine"};
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

Implementations search_path(const ProjectFolders& folders, const std::string& step, const grade::Code& code,
                            const Owners& earlier) {
  std::vector<Implementations::Root> roots;
  const auto add = [&](const grade::Code& from, const std::string& only_step) {
    for (const fs::path& folder : {from.libraries, from.sources})
      if (fs::is_directory(folder)) roots.push_back({folder, only_step});
  };
  add(code, step);
  for (const auto& [name, owner] : earlier) add(code_of(folders, owner), name);
  add(code_of(folders, Owner::solution), "");
  add(code_of(folders, Owner::mine), "");
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
