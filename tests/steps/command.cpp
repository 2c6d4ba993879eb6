#include "command.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "base/error.hpp"
#include "base/file.hpp"
#include "catch.hpp"

namespace atelier::test {

ProjectFolders folders() {
  return {.root = ATELIER_ROOT, .build = ATELIER_BUILD};
}

bool is_whole_course() {
  return std::getenv("ATELIER_TEST_STEP") == nullptr;
}

std::vector<CourseStep> course() {
  const auto all = read_course(folders().step_flags());
  if (is_whole_course()) return all;
  return {resolve_step(all, std::getenv("ATELIER_TEST_STEP"))};
}

namespace {

/// What git prints, without the line break at its end; empty if it fails.
std::string git(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"git", "-C", folders().root.string()});
  try {
    Finished finished = run_process({.arguments = arguments});
    if (!finished.ok()) return "";
    return finished.output.substr(0, finished.output.find_last_not_of('\n') + 1);
  } catch (const Error&) {
    return "";  // there is no git
  }
}

std::vector<CourseStep> choose_steps_in_turn() {
  std::vector<CourseStep> steps = course();
  const char* turn = std::getenv("ATELIER_TEST_TURN");
  const std::string commit = git({"rev-parse", "HEAD"});
  if (!is_whole_course() || (turn && std::string(turn) == "all") || commit.empty()) return steps;
  const std::string changed =
      git({"log", "-1", "--format=", "--name-only", "--", "solutions", "steps", "tests/cases", "tests/mistakes"}) +
      git({"status", "--porcelain", "-uall", "--", "solutions", "steps", "tests"});
  constexpr std::size_t turns = 3;
  const std::size_t now = std::stoul(commit.substr(0, 7), nullptr, 16) % turns;
  std::vector<CourseStep> chosen;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (i % turns == now || changed.find("/" + steps[i].name + "/") != changed.npos) chosen.push_back(steps[i]);
  return chosen;
}

}  // namespace

const std::vector<CourseStep>& steps_in_turn() {
  static const std::vector<CourseStep> steps = choose_steps_in_turn();
  return steps;
}

std::vector<std::string> with_steps(std::vector<std::string> arguments, const std::vector<CourseStep>& steps) {
  if (!is_whole_course() || steps.size() < course().size())
    for (const CourseStep& step : steps) arguments.push_back(step.name);
  return arguments;
}

Finished run_atelier(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), (folders().build / "bin" / "atelier").string());
  // Commands on all steps take minutes; ctest's own limit is 900 s.
  return run_process({.arguments = arguments,
                      .folder = folders().root,
                      .time_limit = std::chrono::seconds(880),
                      .output_limit = 16 << 20});
}

nlohmann::json graded(const std::filesystem::path& submission, const std::vector<std::string>& options) {
  const TemporaryFolder out("atelier-steps-test");
  std::vector<std::string> arguments = {"grade", submission.string(), "--out", out.path().string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const bool names_steps = std::find(options.begin(), options.end(), "--step") != options.end();
  if (!is_whole_course() && !names_steps) arguments.insert(arguments.end(), {"--step", course().front().name});
  const Finished finished = run_atelier(arguments);
  INFO(finished.output);
  REQUIRE(finished.exit_status == 0);
  return nlohmann::json::parse(read_file(out.path() / "results.json"));
}

Printed printed(std::vector<std::string> arguments) {
  arguments.push_back("--json");
  const Finished finished = run_atelier(arguments);
  INFO(finished.output);
  REQUIRE(finished.exit_status != 2);
  return {nlohmann::json::parse(finished.output), finished.exit_status};
}

}  // namespace atelier::test
