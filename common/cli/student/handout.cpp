#include "cli/student/handout.hpp"

#include <filesystem>

#include "base/file.hpp"

namespace atelier {
namespace {

std::string name_of(const CourseStep& step) {
  return "handouts/" + step.name + ".md";
}

std::string text_of(const ProjectFolders& folders, const CourseStep& step) {
  const auto path = folders.root / name_of(step);
  return std::filesystem::is_regular_file(path) ? read_file(path, 4 << 20) : std::string();
}

/// Markdown as plain text in one line, without markup of emphasis and formulas.
std::string plain(std::string_view markdown) {
  std::string text;
  for (const char c : markdown)
    if (c == '\n')
      text += ' ';
    else if (c != '*' && c != '$' && c != '`')
      text += c;
  return text;
}

}  // namespace

std::string goal_of(const ProjectFolders& folders, const CourseStep& step) {
  const std::string text = text_of(folders, step);
  const std::size_t begin = text.find("\n**Afterwards you can");
  if (begin == text.npos) return step.title;
  return plain(std::string_view(text).substr(begin + 1, text.find("\n\n", begin + 1) - begin - 1));
}

std::string handout_of(const ProjectFolders& folders, const CourseStep& step) {
  return text_of(folders, step).empty() ? "" : name_of(step);
}

std::string further_reading_of(const ProjectFolders& folders, const CourseStep& step) {
  const bool has = text_of(folders, step).find("\n## Further reading\n") != std::string::npos;
  return has ? name_of(step) + ", \"Further reading\"" : "";
}

}  // namespace atelier
