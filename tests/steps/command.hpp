// Runs the atelier command as a person does, and reads what it has written.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "cli/layout.hpp"

namespace atelier::test {

/// The folders of the project under test. The ones compiled into the command are the same: one CMake made both.
ProjectFolders folders();
/// The steps of the course; where ATELIER_TEST_STEP names one, that one alone. Tests with the tag [each-step] go
/// through it, and so can be run for one step: ./atelier test --step NN.
std::vector<CourseStep> course();
/// Of course() the steps whose turn it is, for topics that take minutes over all of them: the time of a run must not
/// grow with the course. One step in three, which the tested commit decides, the step that was committed last, and
/// those with changes that are not committed. All of them where ATELIER_TEST_TURN is "all" (./atelier test --all), and
/// outside of a git working tree.
const std::vector<CourseStep>& steps_in_turn();
/// A command with steps behind it; without any where they are the whole course.
std::vector<std::string> with_steps(std::vector<std::string> arguments,
                                    const std::vector<CourseStep>& steps = course());
/// Whether course() is all.
bool is_whole_course();

/// The program behind ./atelier; the launcher would build, and the build is running these tests.
Finished run_atelier(std::vector<std::string> arguments);

/// results.json of `grade SUBMISSION OPTIONS...`, whose exit status must be 0. Where the options name no step: of the
/// steps of course().
nlohmann::json graded(const std::filesystem::path& submission, const std::vector<std::string>& options = {});

/// What `command ... --json` prints, and its exit status.
struct Printed {
  nlohmann::json json;
  int exit_status = 0;
};
Printed printed(std::vector<std::string> arguments);

}  // namespace atelier::test
