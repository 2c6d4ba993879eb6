#include "cli/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/strict_json.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using strict_json::Json;

std::vector<std::string> texts(const Json& lists, const std::string& step, const std::string& where) {
  const Json* list = strict_json::optional(lists, step.c_str());
  if (list == nullptr) return {};
  if (!list->is_array()) strict_json::refuse(*list, where + ": " + step, "a list of texts");
  std::vector<std::string> out;
  for (const Json& text : *list) out.push_back(strict_json::text(text, where + ": " + step));
  return out;
}

std::vector<std::string> names_of(const std::vector<CourseStep>& course) {
  std::vector<std::string> names;
  for (const CourseStep& step : course) names.push_back(step.name);
  return names;
}

bool is_number(const std::string& text) {
  return !text.empty() && text.size() <= 4 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Whether `text` names `step`: 2 for its number or name, 1 for a part of the name, otherwise 0.
int match(const CourseStep& step, const std::string& text) {
  if (text == step.name || (is_number(text) && is_number(step.number()) && std::stoi(text) == std::stoi(step.number())))
    return 2;
  return !text.empty() && step.name.find(text) != std::string::npos ? 1 : 0;
}

}  // namespace

ProjectFolders project_folders() {
  ProjectFolders folders{.root = ATELIER_ROOT, .build = ATELIER_BUILD};
  if (const char* work = std::getenv("ATELIER_WORK"); work && *work) {
    folders.work = fs::absolute(work);
    if (!fs::is_directory(folders.work))
      throw Error(fmt::format("ATELIER_WORK is '{}', but there is no such folder", work));
    std::error_code error;
    fs::create_directory(folders.steps(), error);
    if (!fs::is_directory(folders.steps()))
      throw Error(fmt::format("ATELIER_WORK is '{}', in which no folder steps can be made", work));
  }
  return folders;
}

bool is_release() {
  return fs::exists(fs::path(ATELIER_ROOT) / "release.sha256");
}

std::vector<CourseStep> read_course(const fs::path& step_flags) {
  const std::string where = step_flags.string();
  const Json document = strict_json::parse(read_file(step_flags, 1 << 20), where);
  if (!document.is_object()) throw Error(where + ": must be an object; configure the project again");
  const Json& files = strict_json::required(document, "files", where);
  const Json& titles = strict_json::required(document, "titles", where);
  if (!files.is_object() || files.empty()) strict_json::refuse(files, where + ": files", "an object with every step");

  std::vector<CourseStep> course;
  for (const auto& [name, list] : files.items())
    course.push_back(
        {.name = name,
         .title = strict_json::text(strict_json::required(titles, name.c_str(), where + ": titles"), where),
         .files = texts(files, name, where + ": files"),
         .headers = texts(strict_json::required(document, "headers", where), name, where + ": headers"),
         .uses = texts(strict_json::required(document, "uses", where), name, where + ": uses")});
  std::sort(course.begin(), course.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return course;
}

const CourseStep& resolve_step(const std::vector<CourseStep>& course, const std::string& text) {
  std::vector<const CourseStep*> parts;
  for (const CourseStep& step : course) {
    const int how = match(step, text);
    if (how == 2) return step;
    if (how == 1) parts.push_back(&step);
  }
  if (parts.size() == 1) return *parts.front();
  if (parts.empty())
    throw Error(fmt::format("step '{}': there is no such step{}", text, suggestion(text, names_of(course))));
  std::vector<std::string> names;
  for (const CourseStep* step : parts) names.push_back(step->name);
  throw Error(fmt::format("step '{}': this could be {}", text, join(names, " or ")));
}

std::vector<CourseStep> resolve_steps(const std::vector<CourseStep>& course, const std::vector<std::string>& texts) {
  if (texts.empty()) return course;
  std::vector<CourseStep> steps;
  for (const std::string& text : texts) steps.push_back(resolve_step(course, text));
  std::sort(steps.begin(), steps.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  steps.erase(std::unique(steps.begin(), steps.end(), [](const auto& a, const auto& b) { return a.name == b.name; }),
              steps.end());
  return steps;
}

}  // namespace atelier
