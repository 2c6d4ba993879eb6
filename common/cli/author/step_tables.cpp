#include "cli/author/step_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/strict_json.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using strict_json::Json;

const std::vector<std::string> tiers = {"core", "further", "challenge"};

struct Words {
  std::string picture, sentence, topics, hours;
};

fs::path words_folder(const ProjectFolders& folders) {
  return folders.root / "docs" / "steps";
}

Words words_of(const ProjectFolders& folders, const CourseStep& step) {
  const fs::path file = words_folder(folders) / (step.name + ".json");
  const std::string where = file.string();
  const Json document = strict_json::parse(read_file(file, 1 << 16), where);
  strict_json::refuse_unknown(document, {"picture", "sentence", "topics", "hours"}, where);
  const auto member = [&](const char* name) {
    return strict_json::text(strict_json::required(document, name, where), where + ": " + name);
  };
  Words words{member("picture"), member("sentence"), member("topics"), {}};
  if (document.contains("hours")) words.hours = member("hours");
  return words;
}

std::map<std::string, double> points_of(const ProjectFolders& folders, const CourseStep& step) {
  std::map<std::string, double> points;
  for (const auto& c : judge::read_case_file(folders.case_file(step.name)).cases) points[c.tier] += c.points;
  return points;
}

/// The hours of each tier from the handout's table, "5 + 2 + 1½"; empty without one.
std::string hours_of(const ProjectFolders& folders, const CourseStep& step) {
  const std::string handout = read_file(folders.handouts() / (step.name + ".md"), 4 << 20);
  std::vector<std::string> hours;
  for (const std::string& tier : tiers) {
    std::smatch row;
    if (std::regex_search(handout, row, std::regex("\n\\| " + tier + " \\| ([^|]+) \\| [0-9.]+ \\|")))
      hours.push_back(row[1]);
  }
  return join(hours, " + ");
}

/// Rows of README.md for steps that are planned.
std::string planned_rows(const ProjectFolders& folders, const std::vector<CourseStep>& course) {
  const fs::path file = words_folder(folders) / "planned.json";
  const std::string where = file.string();
  std::string rows;
  for (const Json& planned : strict_json::parse(read_file(file, 1 << 16), where)) {
    strict_json::refuse_unknown(planned, {"step", "sentence"}, where);
    const std::string step = strict_json::text(strict_json::required(planned, "step", where), where + ": step");
    const std::string sentence =
        strict_json::text(strict_json::required(planned, "sentence", where), where + ": sentence");
    const bool made = std::any_of(course.begin(), course.end(),
                                  [&](const CourseStep& s) { return s.number() == step.substr(0, step.find('-')); });
    if (!made) rows += fmt::format("| *planned* | {} | | {} |\n", step, sentence);
  }
  return rows;
}

}  // namespace

std::string rows_of_readme(const ProjectFolders& folders, const std::vector<CourseStep>& course) {
  std::string rows;
  for (const CourseStep& step : course) {
    const Words words = words_of(folders, step);
    double all = 0;
    for (const auto& [tier, points] : points_of(folders, step)) all += points;
    rows += fmt::format("| ![{}](docs/pictures/{}.png) | **{}** ([handout](handouts/{}.md)) | {} | {} |\n",
                        words.picture, step.name, step.name, step.name, all, words.sentence);
  }
  return rows + planned_rows(folders, course);
}

std::string rows_of_handouts(const ProjectFolders& folders, const std::vector<CourseStep>& course) {
  std::string rows;
  for (const CourseStep& step : course) {
    const Words words = words_of(folders, step);
    std::map<std::string, double> points = points_of(folders, step);
    const std::string sum = points["core"] == 0
                                ? "none"
                                : fmt::format("{} + {} + {}", points["core"], points["further"], points["challenge"]);
    rows += fmt::format("| {} | [{}]({}.md): {} | {} | {} |\n", step.number(), step.title, step.name, words.topics, sum,
                        words.hours.empty() ? hours_of(folders, step) : words.hours);
  }
  return rows;
}

std::string with_rows(const std::string& text, const std::string& rows, const std::string& file) {
  const std::size_t begin = text.find(table_begins), end = text.find(table_ends);
  std::size_t head = begin;
  for (int line = 0; line < 3 && head < end; ++line) head = text.find('\n', head) + 1;
  if (begin == text.npos || end == text.npos || head > end || text[begin + table_begins.size()] != '|' ||
      text.find(table_begins, begin + 1) != text.npos)
    throw Error(fmt::format("{}: must have one table between the lines '{}' and '{}'", file,
                            table_begins.substr(0, table_begins.size() - 1),
                            table_ends.substr(0, table_ends.size() - 1)));
  return text.substr(0, head) + rows + text.substr(end);
}

}  // namespace atelier
