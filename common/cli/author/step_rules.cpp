#include "cli/author/step_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "cli/author/mistake_list.hpp"
#include "cli/author/truth_agreement.hpp"
#include "cli/student/hints.hpp"
#include "judge/compare/mistakes.hpp"
#include "judge/compare/references.hpp"
#include "measure/expect.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using judge::JudgedCase;

/// The concatenated sources of a folder whose names begin with `beginning`; empty if there are none.
std::string sources_in(const fs::path& folder, const std::string& beginning = "") {
  std::string text;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing))
    if (entry.path().extension() == ".cpp" && entry.path().filename().string().starts_with(beginning))
      text += read_file(entry.path());
  return text;
}

bool has_cpp(const CourseStep& step) {
  return std::any_of(step.files.begin(), step.files.end(), [](const std::string& f) { return f.ends_with(".cpp"); });
}

/// The text of the step's handout, empty if there is none.
std::string handout_text(const ProjectFolders& folders, const std::string& step) {
  const fs::path file = folders.handouts() / (step + ".md");
  return fs::exists(file) ? read_file(file, 4 << 20) : std::string();
}

Problems problems_of_handout(const ProjectFolders& folders, const CourseStep& step,
                             const std::vector<JudgedCase>& cases) {
  const std::string file = fmt::format("handouts/{}.md", step.name), handout = handout_text(folders, step.name);
  if (handout.empty()) return {file + " is missing: goal, theory, tasks, troubleshooting, extreme inputs"};
  Problems problems;
  std::map<std::string, double> points = {{"core", 0}, {"further", 0}, {"challenge", 0}};
  for (const JudgedCase& c : cases) {
    points[c.tier] += c.points;
    if (c.points > 0 && !c.hidden && handout.find('`' + c.ask.name + '`') == handout.npos)
      problems.push_back(
          fmt::format("{} does not name the case `{}`: add it to a table of the tasks", file, c.ask.name));
  }
  if (points["core"] == 0) return problems;
  for (const auto& [tier, sum] : points) {
    std::smatch row;
    const bool has_row = std::regex_search(handout, row, std::regex("\n\\| " + tier + " \\| [^|]+ \\| ([0-9.]+) \\|"));
    if (sum == 0 && has_row)
      problems.push_back(
          fmt::format("{}: the table of tiers has a row of {}, and no case has points there", file, tier));
    if (sum > 0 && (!has_row || row[1] != fmt::format("{}", sum)))
      problems.push_back(
          fmt::format("{}: the table of tiers must have a row | {} | HOURS | {} | WHAT |", file, tier, sum));
  }
  return problems;
}

}  // namespace

Problems problems_of_tests(const ProjectFolders& folders, const CourseStep& step) {
  const fs::path tests = folders.root / "tests";
  Problems problems;
  if (!fs::exists(tests / "steps") || !has_cpp(step)) return problems;
  if (sources_in(tests / "steps", "required").find(fmt::format("[{}]", step.name)) == std::string::npos)
    problems.push_back(
        fmt::format("tests/steps/required*.cpp has no test with the tags [required][{}]: add a row for each optional "
                    "feature of a scene: unused features must cost nothing",
                    step.name));
  if (!fs::exists(folders.case_file(step.name))) return problems;
  const std::string extremes = sources_in(tests / "stability" / step.name);
  for (const std::string& function : judge::functions_of(judge::read_case_file(folders.case_file(step.name)).cases))
    if (!std::regex_search(extremes, std::regex("\\b" + function + "\\b")))
      problems.push_back(
          fmt::format("tests/stability/{}/ has nothing about {}: add a group of rows (and a table.cpp where "
                      "there is none), or say in a comment why it has no extremes",
                      step.name, function));
  return problems;
}

Problems problems_of_cases(const ProjectFolders& folders, const CourseStep& step) {
  const judge::CaseFile cases = judge::read_case_file(folders.case_file(step.name));
  Problems problems = problems_of_handout(folders, step, cases.cases);
  try {
    read_hints(folders.hints_file(step.name), cases);
  } catch (const Error& error) {
    problems.push_back(error.what());
  }
  return problems;
}

Problems problems_of_truth(const ProjectFolders& folders, const CourseStep& step,
                           const std::vector<std::string>& names) {
  std::vector<JudgedCase> cases = pictures_of(folders, step);
  std::erase_if(cases,
                [&](const JudgedCase& c) { return std::find(names.begin(), names.end(), c.ask.name) == names.end(); });
  Problems problems;
  if (cases.empty()) return problems;
  const Workshop workshop(folders, step);
  const auto truth = truths(workshop, workshop.solution(), with_edges(asks_of(cases)));
  const judge::StepReferences references(step.name, {}, judge::references_folder(folders.case_file(step.name)), {});
  for (const JudgedCase& c : cases) {
    const std::string where = fmt::format("tests/cases/{}/cases.json: case '{}'", step.name, c.ask.name);
    if (!truth.contains(c.ask.name)) {
      if (c.truth_differs.empty())
        problems.push_back(
            where +
            ": the program has no --truth for it: make one in given/truth.cpp, or say under truth_differs why not");
      continue;
    }
    const Agreement found = agreement(c.ask.name, references.of(c).pictures.at(0), truth, closeness(c));
    if (!found.holds() && c.truth_differs.empty())
      problems.push_back(
          fmt::format("{} is not the ground truth ({}): compare both and fix one, or say under truth_differs which "
                      "approximation the case is about",
                      where, in_words(found)));
    if (found.holds() && !c.truth_differs.empty())
      problems.push_back(where + " is the ground truth: remove its truth_differs");
  }
  return problems;
}

Problems problems_of_mistakes(const ProjectFolders& folders, const CourseStep& step) {
  Problems problems;
  for (const fs::path& list : {folders.mistakes_file(step.name), folders.variants_file(step.name)})
    if (fs::exists(list) && read_file(list).find(to_be_written) != std::string::npos)
      problems.push_back(
          fmt::format("{}: something is still '{}...'", list.lexically_relative(folders.root).string(), to_be_written));
  for (const judge::Mistake& mistake : judge::read_mistakes(folders.mistakes_file(step.name)))
    if (mistake.spellings.empty())
      problems.push_back(fmt::format(
          "tests/mistakes/{}/mistakes.json: '{}' has no second spelling: ./atelier mistake {} {} --spelling --begin",
          step.name, mistake.name, step.number(), mistake.name));
  if (!fs::exists(folders.variants_file(step.name)))
    problems.push_back(
        fmt::format("tests/variants/{}/variants.json is missing: ./atelier mistake {} NAME --variant --begin",
                    step.name, step.number()));
  return problems;
}

Problems problems_of_measured(const ProjectFolders& folders, const measure::StepMeasured& measured) {
  const std::string file = fmt::format("tests/cases/{}/measure.json", measured.step);
  const std::string handout = handout_text(folders, measured.step), number = measured.step.substr(0, 2);
  Problems problems;
  int slopes = 0, in_handout = 0;
  for (const measure::SweepResult& sweep : measured.sweeps) {
    const auto curves = measure::curves_of(sweep);
    slopes += sweep.plan.count.empty() && std::any_of(curves.begin(), curves.end(), [&](const auto& c) {
                return measure::fit_of(sweep, c).has_value();
              });
    in_handout += sweep.plan.handout;
    if (sweep.plan.expect.empty())
      problems.push_back(
          fmt::format("{}: sweep '{}' has no \"expect\": say what theory expects of it", file, sweep.plan.name));
    const std::string plot = fmt::format("](plots/{}-{}.svg)", number, sweep.plan.name);
    if (sweep.plan.handout && handout.find(plot) == handout.npos)
      problems.push_back(fmt::format("handouts/{}.md does not show the plot of sweep '{}': add ![WHAT IT SHOWS{}",
                                     measured.step, sweep.plan.name, plot));
  }
  if (slopes < 2)
    problems.push_back(
        fmt::format("{}: {} of its sweeps have errors with a slope, and two must: sweep a number whose error goes by a "
                    "power of it, over values enough above the smallest error",
                    file, slopes));
  if (in_handout == 0)
    problems.push_back(file + ": no sweep has \"handout\": true: choose the one that a reader learns most from");
  return problems;
}

std::string in_lines(const Problems& problems) {
  std::string lines;
  for (const std::string& problem : problems) lines += "! " + problem + "\n";
  return lines;
}

}  // namespace atelier
