// The tasks of .vscode/tasks.json, and their problem matchers as an editor applies them: each pattern to one line.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <string>

namespace atelier::test {

/// The file, which must be strict JSON: a release is made from it.
inline nlohmann::json editor_file(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(ATELIER_SOURCE_DIR "/.vscode/" + name));
}

/// The task with this label.
inline nlohmann::json editor_task(const std::string& label) {
  const nlohmann::json file = editor_file("tasks.json");
  for (const nlohmann::json& task : file.at("tasks"))
    if (task.at("label") == label) return task;
  throw std::out_of_range("tasks.json has no task " + label);
}

/// What a pattern of a matcher captures from a line; none if it does not match. A group that takes no part is empty.
inline std::optional<nlohmann::json> problem_in(const std::string& line, const nlohmann::json& matcher) {
  const nlohmann::json& pattern = matcher.at("pattern");
  std::smatch groups;
  if (!std::regex_search(line, groups, std::regex(pattern.at("regexp").get<std::string>()))) return {};
  nlohmann::json problem;
  for (const char* part : {"file", "line", "column", "severity", "message"})
    problem[part] = pattern.contains(part) ? groups[pattern[part].get<std::size_t>()].str() : "";
  return problem;
}

}  // namespace atelier::test
