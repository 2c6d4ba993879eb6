#include "cli/student/standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "judge/compare/judged_case.hpp"
#include "judge/report/report_words.hpp"

namespace atelier {
namespace {

std::string share(const Standing& standing) {
  using judge::points_text;
  if (standing.max_score > 0) return points_text(standing.score) + "/" + points_text(standing.max_score);
  return fmt::format("{} of {} cases", standing.cases_passed, standing.cases);
}

}  // namespace

Standing standing_of(const ProjectFolders& folders, const CourseStep& step, const ProgressRecord& record) {
  Standing standing{.step = step};
  const auto found = record.find(step.name);
  const StepProgress progress = found == record.end() ? StepProgress{} : found->second;
  for (const auto& [name, level] : progress.hints) standing.hints += level;
  standing.best = progress.best;

  std::vector<std::string> cases;
  if (std::filesystem::exists(folders.case_file(step.name)))  // a new step may have none yet
    for (const judge::JudgedCase& c : judge::read_case_file(folders.case_file(step.name)).cases) {
      cases.push_back(c.ask.name);
      standing.max_score += c.points;
    }
  standing.cases = int(cases.size());
  if (!progress.check) return standing;

  standing.checked = true;
  standing.score = progress.check->score;
  standing.passed = !cases.empty() && has_passed(progress, cases, progress.check->files);
  standing.changed = digest_of_files(folders.steps() / step.name, step.files) != progress.check->files;
  standing.cases_passed = int(std::count_if(cases.begin(), cases.end(), [&](const std::string& name) {
    const auto c = progress.check->cases.find(name);
    return c != progress.check->cases.end() && c->second;
  }));
  return standing;
}

std::vector<Standing> standings(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                                const ProgressRecord& record) {
  std::vector<Standing> all;
  for (const CourseStep& step : course) all.push_back(standing_of(folders, step, record));
  return all;
}

std::string in_words(const Standing& standing) {
  if (!standing.checked) return "not checked yet";
  return (standing.passed ? "passed" : share(standing)) + (standing.changed ? ", edited since" : "");
}

const Standing* next_step(const std::vector<Standing>& standings) {
  const auto found =
      std::find_if(standings.begin(), standings.end(), [](const Standing& s) { return !s.passed && s.cases > 0; });
  return found == standings.end() ? nullptr : &*found;
}

std::string progress_line(const std::vector<Standing>& standings, bool unicode) {
  std::string line;
  for (const Standing& standing : standings) {
    const std::string sign = standing.passed    ? (unicode ? "\u2713" : "+")
                             : standing.checked ? share(standing)
                                                : (unicode ? "\u00b7" : "-");
    line += (line.empty() ? "" : "  ") + standing.step.number() + " " + sign;
  }
  return line;
}

}  // namespace atelier
