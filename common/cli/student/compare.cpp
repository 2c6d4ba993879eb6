// ./atelier compare: prints a student's functions and the solution's, after they have passed.
#include <fmt/format.h>

#include <map>
#include <optional>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "cli/author/marked_text.hpp"
#include "cli/commands.hpp"
#include "cli/layout.hpp"
#include "cli/search_path.hpp"
#include "cli/student/function_text.hpp"
#include "cli/student/progress_record.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

/// For each function: whether the last full check passed every case that names it.
std::map<std::string, bool> functions_of(const judge::CaseFile& cases, const StepProgress& progress) {
  std::map<std::string, bool> functions;
  for (const judge::JudgedCase& c : cases.cases)
    for (const std::string& function : c.functions) {
      const bool passed =
          progress.check && progress.check->cases.contains(c.ask.name) && progress.check->cases.at(c.ask.name);
      const auto [entry, is_new] = functions.emplace(function, passed);
      if (!is_new) entry->second = entry->second && passed;
    }
  return functions;
}

void print_one(const std::string& whose, const fs::path& file, const std::optional<FunctionText>& found) {
  if (found)
    fmt::print("--- {}: {}:{}\n{}\n", whose, file.string(), found->line, printable(found->text, Layout::keep_lines));
  else
    fmt::print("--- {}: {} has no such function\n\n", whose, file.string());
}

/// A function may be in a C++ file and in a shader.
void print_both(const ProjectFolders& folders, const CourseStep& step, const std::string& function) {
  for (const std::string& file : step.files) {
    const fs::path mine = fs::path("steps") / step.name / file, theirs = fs::path("solutions") / step.name / file;
    const std::string marked = read_file(folders.root / theirs);
    auto solution = find_function(finished_text(marked, theirs.string()), function);
    if (!solution) continue;
    solution->line = find_function(marked, function).value_or(*solution).line;  // line numbers include the marks
    print_one("yours", mine,
              find_function(fs::exists(folders.own() / mine) ? read_file(folders.own() / mine) : "", function));
    print_one("solution", theirs, solution);
  }
}

}  // namespace

int run_compare(const CompareOptions& options) {
  const ProjectFolders folders = project_folders();
  const auto course = read_course(folders.step_flags());
  const CourseStep& step = resolve_step(course, options.step);
  if (!is_solution_readable(folders, step))
    throw Error(fmt::format("compare: this copy of the course has no solution of {} to read", step.name));
  const ProgressRecord record = read_progress(folders.progress());
  const auto progress = record.find(step.name);
  const auto functions = functions_of(judge::read_case_file(folders.case_file(step.name)),
                                      progress == record.end() ? StepProgress{} : progress->second);

  if (!options.function.empty() && !functions.contains(options.function)) {
    std::vector<std::string> names;
    for (const auto& [name, passed] : functions) names.push_back(name);
    throw Error(fmt::format("{}: function '{}': there is none{}", step.name, options.function,
                            suggestion(options.function, names)));
  }
  int shown = 0;
  for (const auto& [name, passed] : functions) {
    if (!options.function.empty() && name != options.function) continue;
    if (!passed && !options.spoil) continue;
    print_both(folders, step, name);
    ++shown;
  }
  if (shown > 0) return exit_ok;
  fmt::print(
      "{} has not passed every case yet, as of your last check. Hints: ./atelier hint {}. (--spoil shows the solution "
      "anyway.)\n",
      options.function.empty() ? step.name : options.function, step.number());
  return exit_failed;
}

}  // namespace atelier
