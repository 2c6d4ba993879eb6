#include "command.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>

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

std::vector<std::string> with_steps(std::vector<std::string> arguments) {
  if (!is_whole_course()) arguments.push_back(course().front().name);
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
