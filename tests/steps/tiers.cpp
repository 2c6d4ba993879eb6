// The core can be passed with the core alone, and the further part with these two: no case needs a function of later
// tiers only.
#include <algorithm>
#include <set>
#include <sstream>

#include "base/file.hpp"
#include "catch.hpp"
#include "cli/author/unwritten.hpp"
#include "command.hpp"
#include "judge/compare/judged_case.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

namespace {

const std::vector<std::string> tiers{"core", "further", "challenge"};

bool within(const judge::JudgedCase& c, const std::string& last) {
  return std::find(tiers.begin(), tiers.end(), c.tier) <= std::find(tiers.begin(), tiers.end(), last);
}

/// The functions that cases name, up to a tier.
std::set<std::string> named_up_to(const std::vector<judge::JudgedCase>& cases, const std::string& last) {
  std::set<std::string> names;
  for (const judge::JudgedCase& c : cases)
    if (within(c, last)) names.insert(c.functions.begin(), c.functions.end());
  return names;
}

/// A file of choices without those of later cases.
std::string without_later(const std::string& choices, const std::vector<judge::JudgedCase>& cases,
                          const std::string& last) {
  std::string kept;
  std::istringstream lines(choices);
  for (std::string line; std::getline(lines, line);) {
    const bool later = std::ranges::any_of(
        cases, [&](const judge::JudgedCase& c) { return !within(c, last) && line.starts_with(c.ask.name + ":"); });
    if (!later) kept += line + "\n";
  }
  return kept;
}

/// Of the steps in turn, what a student hands in who stops behind a tier. Returns how many functions are left out.
std::size_t stop_behind(const std::string& last, const std::filesystem::path& folder) {
  std::size_t left_out = 0;
  for (const CourseStep& step : steps_in_turn()) {
    const auto cases = judge::read_case_file(folders().case_file(step.name)).cases;
    const std::set<std::string> all = named_up_to(cases, tiers.back()), done = named_up_to(cases, last);
    std::set<std::string> later;
    std::set_difference(all.begin(), all.end(), done.begin(), done.end(), std::inserter(later, later.end()));
    left_out += later.size();
    std::filesystem::create_directories(folder / step.name);
    for (const std::string& file : step.files) {
      const std::string solved = read_file(folders().solutions() / step.name / file);
      write_file(folder / step.name / file, file == "choices.txt" ? without_later(solved, cases, last)
                                                                  : with_unwritten(solved, later, file, step.name));
    }
  }
  return left_out;
}

}  // namespace

TEST_CASE("no tier needs the work of later tiers", "[tiers][each-step]") {
  for (const std::string last : {"core", "further"}) {
    const TemporaryFolder submission;
    const std::size_t left_out = stop_behind(last, submission.path());
    if (is_whole_course()) CHECK(left_out > 0);
    std::vector<std::string> these;
    for (const CourseStep& step : steps_in_turn()) these.insert(these.end(), {"--step", step.name});
    const json results = graded(submission.path(), these);
    REQUIRE(results["steps"].size() == steps_in_turn().size());
    for (const json& step : results["steps"]) {
      const std::string name = step["step"];
      CHECK(step["build_log"] == "");
      std::set<std::string> meant;
      for (const auto& c : judge::read_case_file(folders().case_file(name)).cases)
        if (within(c, last)) meant.insert(c.ask.name);
      bool later_fail = false;
      for (const json& c : step["cases"]) {
        INFO(name << ", " << last << ": " << c["name"].get<std::string>() << ": " << c["reason"].get<std::string>());
        if (meant.contains(c["name"])) CHECK(c["status"] == "passed");
        later_fail |= !meant.contains(c["name"]) && c["status"] != "passed";
      }
      // Else nothing was left out, and nothing was proven.
      if (meant.size() < step["cases"].size()) CHECK(later_fail);
    }
  }
}
