#include "cli/grader/release_contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "base/sealed.hpp"
#include "base/sha256.hpp"
#include "base/strict_json.hpp"
#include "cli/author/marked_text.hpp"
#include "cli/grader/release_leaks.hpp"
#include "cli/grader/solution_for_later_steps.hpp"
#include "cli/grader/visible_cases.hpp"
#include "judge/compare/mistakes.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

/// The files that git tracks; nothing if the project is not a git working tree or git is missing.
std::optional<std::set<std::string>> files_of_git(const fs::path& root) {
  std::set<std::string> files;
  try {
    const Finished git =
        run_process({.arguments = {"git", "-C", root.string(), "ls-files", "-z"}, .output_limit = 64 << 20});
    if (!git.ok()) return std::nullopt;
    for (std::size_t begin = 0; begin < git.output.size();) {
      const std::size_t end = std::min(git.output.find('\0', begin), git.output.size());
      files.insert(git.output.substr(begin, end - begin));
      begin = end + 1;
    }
  } catch (const Error&) {
    return std::nullopt;
  }
  if (!files.contains("CMakeLists.txt")) return std::nullopt;  // a copy inside another working tree
  return files;
}

bool contains(const std::vector<CourseStep>& steps, const CourseStep& step) {
  return std::any_of(steps.begin(), steps.end(), [&](const CourseStep& s) { return s.name == step.name; });
}

/// The steps that `steps` use, directly or indirectly; some of `steps` may be among them. In `course` each step comes
/// after all that it uses.
std::vector<CourseStep> used_steps(const std::vector<CourseStep>& course, const std::vector<CourseStep>& steps) {
  std::set<std::string> names;
  std::vector<CourseStep> used;
  for (auto step = course.rbegin(); step != course.rend(); ++step) {
    const bool is_used = names.contains(step->name);
    if (!is_used && !contains(steps, *step)) continue;
    names.insert(step->uses.begin(), step->uses.end());
    if (is_used) used.insert(used.begin(), *step);
  }
  return used;
}

std::vector<CourseStep> without(std::vector<CourseStep> steps, const std::vector<CourseStep>& others) {
  std::erase_if(steps, [&](const CourseStep& step) { return contains(others, step); });
  return steps;
}

int count_files(const fs::path& folder, const std::string& extension = "") {
  int count = 0;
  if (!fs::is_directory(folder)) return 0;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && (extension.empty() || entry.path().extension() == extension)) ++count;
  return count;
}

class Packer {
 public:
  Packer(const ProjectFolders& folders, const std::vector<CourseStep>& course, const std::vector<CourseStep>& steps)
      : folders_(folders),
        steps_(steps),
        used_(used_steps(course, steps)),
        earlier_(without(used_, steps)),
        known_(files_of_git(folders.root)) {
    with_earlier_ = earlier_;
    with_earlier_.insert(with_earlier_.end(), steps.begin(), steps.end());
  }

  Release pack(const std::vector<CourseStep>& course, Earlier earlier) {
    pack_project();
    pack_editor_settings();
    for (const CourseStep& step : with_earlier_) {
      pack_given(step);
      pack_handout(step);
    }
    for (const CourseStep& step : earlier == Earlier::none ? with_earlier_ : steps_) pack_skeletons(step);
    for (const CourseStep& step : steps_) pack_cases(step);
    for (const CourseStep& step : earlier_) release_.earlier.push_back(step.name);
    if (earlier == Earlier::source)
      for (const CourseStep& step : earlier_) pack_solution(step);
    if (earlier == Earlier::library)
      for (const CourseStep& step : used_) pack_library(step);
    const std::vector<CourseStep> secret = earlier == Earlier::source ? without(course, earlier_) : course;
    count_left_out(course, secret);
    refuse_leaks(distinctive_lines(folders_, course, secret));
    pack_manifest();
    return std::move(release_);
  }

 private:
  void put(const std::string& path, std::string bytes) { release_.files[path].bytes = std::move(bytes); }

  /// Packs a file of the project, optionally with another path.
  void take(const std::string& path, const std::string& as = "") {
    put(as.empty() ? path : as, read_file(folders_.root / path));
  }

  /// Packs the tracked files in a folder whose extension or name is in `kinds`.
  void take_below(const std::string& folder, const std::set<std::string>& kinds) {
    for (const auto& entry : fs::recursive_directory_iterator(folders_.root / folder)) {
      const fs::path& path = entry.path();
      if (!entry.is_regular_file() || !(kinds.contains(path.extension()) || kinds.contains(path.filename()))) continue;
      take_known(fs::relative(path, folders_.root).generic_string());
    }
  }

  void take_known(const std::string& path) {
    if (known_ && !known_->contains(path))
      release_.untracked.push_back(path);
    else
      take(path);
  }

  void pack_project() {
    for (const char* file : {"CMakeLists.txt", "CMakePresets.json", "LICENSE", ".clang-format", ".editorconfig",
                             ".gitignore", "atelier", "steps/CMakeLists.txt", "steps/renames.txt"})
      take(file);
    release_.files["atelier"].executable = true;
    take("handouts/README-release.md", "README.md");
    take_below("cmake", {".cmake", ".hpp"});
    take_below("common", {".cpp", ".hpp", ".glsl", ".cmake", ".sh", ".css", ".js", "CMakeLists.txt"});
  }

  /// Without the task that runs the project's tests: a release has none.
  void pack_editor_settings() {
    for (const char* file : {"extensions.json", "launch.json", "settings.json"}) take(std::string(".vscode/") + file);
    OrderedJson file = OrderedJson::parse(read_file(folders_.root / ".vscode/tasks.json"));
    OrderedJson kept = OrderedJson::array();
    for (const OrderedJson& task : file.at("tasks"))
      if (task.at("label") != "test") kept.push_back(task);
    file["tasks"] = std::move(kept);
    put(".vscode/tasks.json", file.dump(2) + "\n");
  }

  /// The contract, the README and the given code, of which second answers are sealed.
  void pack_given(const CourseStep& step) {
    const std::string folder = "steps/" + step.name;
    for (const auto& entry : fs::directory_iterator(folders_.root / folder))
      if (const fs::path& path = entry.path(); path.extension() == ".hpp" || path.filename() == "README.md")
        take_known(folder + "/" + path.filename().string());
    take_below(folder + "/given", {".cpp", ".hpp", ".glsl", ".cmake"});
    for (const auto& entry : fs::directory_iterator(folders_.root / folder / "given"))
      if (is_second_answer(entry.path()))
        if (const auto packed = release_.files.extract(fs::relative(entry.path(), folders_.root).generic_string()))
          put(packed.key() + ".sealed", seal(packed.mapped().bytes));
  }

  void pack_skeletons(const CourseStep& step) {
    for (const std::string& file : step.files) {
      const std::string name = step.name + "/" + file;
      put("skeletons/" + name, cut_skeleton(read_file(folders_.solutions() / name), "solutions/" + name, step.name));
    }
  }

  void pack_handout(const CourseStep& step) {
    if (const std::string page = step.name; fs::exists(folders_.root / page_path(page))) pack_page(page);
  }

  static std::string page_path(const std::string& page) { return "handouts/" + page + ".md"; }

  /// A page of the handouts, with its pictures and the pages that it links. A link to the handout of a step that is not
  /// packed, and one that leads out of the folder, becomes plain text.
  void pack_page(const std::string& page) {
    std::string text = read_file(folders_.root / page_path(page));
    put(page_path(page), "");  // pages may link each other
    static const std::regex picture(R"(\]\(((?:pictures|plots)/[A-Za-z0-9._-]+)\))");
    for (std::sregex_iterator it(text.begin(), text.end(), picture), end; it != end; ++it)
      take("handouts/" + (*it)[1].str());
    static const std::regex link(R"(\[([^\]]*)\]\(((?:\.\./)?[a-z0-9][A-Za-z0-9/-]*)\.md(#[^)]*)?\))");
    std::string out;
    auto rest = text.cbegin();
    for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
      out.append(rest, (*it)[0].first);
      out += is_packed((*it)[2].str()) ? (*it)[0].str() : (*it)[1].str();
      rest = (*it)[0].second;
    }
    put(page_path(page), out.append(rest, text.cend()));
  }

  /// Whether a page that another one links is in the release; packs it if it is not the handout of a step.
  bool is_packed(const std::string& page) {
    if (page.starts_with("../")) return false;
    if (std::isdigit(static_cast<unsigned char>(page.front())))
      return std::ranges::any_of(with_earlier_, [&](const CourseStep& step) { return step.name == page; });
    if (!release_.files.contains(page_path(page))) pack_page(page);
    return true;
  }

  void pack_cases(const CourseStep& step) {
    pack_mistakes(step);
    const VisibleCases visible = visible_cases(folders_.case_file(step.name));
    put("tests/cases/" + step.name + "/cases.json", visible.text);
    for (const fs::path& file : visible.files) take(fs::relative(file, folders_.root).generic_string());
    pack_hints(step, visible);
    if (const fs::path sweeps = folders_.measure_file(step.name); fs::exists(sweeps))
      take(fs::relative(sweeps, folders_.root).generic_string());
    release_.cases += int(visible.cases.size());
    for (const judge::JudgedCase& c : visible.cases) release_.points += c.points;
    release_.hidden += visible.hidden;
    release_.hidden_points += visible.hidden_points;
  }

  /// Without the hints for functions that only hidden cases test.
  void pack_hints(const CourseStep& step, const VisibleCases& visible) {
    const fs::path file = folders_.hints_file(step.name);
    if (!fs::exists(file)) return;
    const std::set<std::string> functions = judge::functions_of(visible.cases);
    OrderedJson hints = OrderedJson::parse(read_file(file));
    OrderedJson kept = OrderedJson::object();
    for (const auto& [function, texts] : hints.at("functions").items())
      if (functions.contains(function)) kept[function] = texts;
    hints["functions"] = std::move(kept);
    put("tests/cases/" + step.name + "/hints.json", hints.dump(2) + "\n");
  }

  /// Only what verdicts need: the mistakes' names and texts, not their patches.
  void pack_mistakes(const CourseStep& step) {
    const fs::path file = folders_.mistakes_file(step.name);
    if (!fs::exists(file)) return;
    OrderedJson list = OrderedJson::array();
    for (const judge::Mistake& mistake : judge::read_mistakes(file, judge::Patches::optional))
      list.push_back(
          {{"name", mistake.name}, {"title", mistake.title}, {"sentence", mistake.sentence}, {"hint", mistake.hint}});
    put("tests/mistakes/" + step.name + "/mistakes.json", list.dump(2) + "\n");
  }

  void pack_solution(const CourseStep& step) {
    for (const std::string& file : step.files)
      put(solution_path(step, file), finished_text_of(solution_path(step, file)));
    release_.carried.push_back(step.name);
  }

  /// What later steps need, and nothing readable: C++ as a library, shaders sealed; later steps read no choices.
  void pack_library(const CourseStep& step) {
    for (auto& [file, bytes] : solution_for_later_steps(folders_, step))
      put(solution_path(step, file), std::move(bytes));
    release_.carried.push_back(step.name);
  }

  static std::string solution_path(const CourseStep& step, const std::string& file) {
    return "solutions/" + step.name + "/" + file;
  }

  /// A file of a solution without the marks for making its skeleton.
  std::string finished_text_of(const std::string& path) const {
    return finished_text(read_file(folders_.root / path), path);
  }

  void count_left_out(const std::vector<CourseStep>& course, const std::vector<CourseStep>& secret) {
    for (const CourseStep& step : secret) release_.solutions += int(step.files.size());
    for (const CourseStep& step : course)
      release_.patches += count_files(folders_.mistakes() / step.name, ".patch") +
                          count_files(folders_.variants() / step.name, ".patch");
    std::sort(release_.untracked.begin(), release_.untracked.end());
  }

  void refuse_leaks(const std::set<std::string>& lines) const {
    const std::vector<Leak> leaks = find_leaks(release_.files, lines);
    if (leaks.empty()) return;
    throw Error(fmt::format("{}: contains a line of a solution, '{}' ({} such lines in total): nothing was released",
                            leaks.front().file, leaks.front().line, leaks.size()));
  }

  void pack_manifest() {
    std::string lines;
    for (const auto& [path, file] : release_.files) lines += sha256(file.bytes) + "  " + path + "\n";
    put("release.sha256", lines);
  }

  const ProjectFolders& folders_;
  std::vector<CourseStep> steps_, used_, earlier_, with_earlier_;  ///< earlier_: used, and not released themselves
  std::optional<std::set<std::string>> known_;
  Release release_;
};

void require_solutions(const ProjectFolders& folders, const std::vector<CourseStep>& course) {
  for (const CourseStep& step : course)
    for (const std::string& file : step.files)
      if (!fs::exists(folders.solutions() / step.name / file))
        throw Error(fmt::format("{}: is missing; a release needs the whole project with all solutions",
                                (folders.solutions() / step.name / file).string()));
}

}  // namespace

Release make_release(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                     const std::vector<CourseStep>& steps, Earlier earlier) {
  require_solutions(folders, course);
  return Packer(folders, course, steps).pack(course, earlier);
}

}  // namespace atelier
