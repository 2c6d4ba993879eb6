#include "cli/grader/release_leaks.hpp"

#include <algorithm>

#include "base/file.hpp"
#include "cli/author/marked_text.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

void append_files_below(const fs::path& folder, std::string& text) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() != ".png" && !is_second_answer(entry.path()))
      text += read_file(entry.path()) + "\n";
}

/// The files of a step that all students get: the contract and the given code.
void append_given_files(const fs::path& folder, std::string& text) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".hpp") text += read_file(entry.path()) + "\n";
  if (fs::is_directory(folder / "given")) append_files_below(folder / "given", text);
}

}  // namespace

bool is_second_answer(const fs::path& given) {
  const std::string name = given.filename().string();
  return given.parent_path().filename() == "given" &&
         (name.ends_with("truth.cpp") ||
          (name.ends_with(".cpp") && (name.starts_with("exact_") || name.starts_with("fast_"))));
}

std::set<std::string> distinctive_lines(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                                        const std::vector<CourseStep>& steps) {
  std::set<std::string> lines;
  std::string given;
  append_files_below(folders.root / "common", given);
  for (const CourseStep& step : course) {
    append_given_files(folders.steps() / step.name, given);
    const bool secret = std::any_of(steps.begin(), steps.end(), [&](const auto& s) { return s.name == step.name; });
    for (const std::string& file : step.files) {
      const std::string where = "solutions/" + step.name + "/" + file;
      const std::string marked = read_file(folders.root / where);
      given += secret ? cut_skeleton(marked, where, step.name) : marked;
      if (!secret) continue;
      for (std::string& line : solution_lines(marked, where))
        if (line.size() >= min_line_length) lines.insert(std::move(line));
    }
  }
  std::erase_if(lines, [&](const std::string& line) { return given.find(line) != given.npos; });
  return lines;
}

std::vector<Leak> find_leaks(const grade::PackedFiles& files, const std::set<std::string>& lines) {
  std::vector<Leak> leaks;
  for (const auto& [name, file] : files) {
    if (file.bytes.find('\0') != file.bytes.npos) continue;
    for (const std::string& line : lines)
      if (file.bytes.find(line) != file.bytes.npos) leaks.push_back({name, line});
  }
  return leaks;
}

}  // namespace atelier
