// A new step, made in a copy of the project by the commands that ./atelier new-step prints: it builds, is judged and
// passes its tests without any other change.
#include <algorithm>
#include <sstream>

#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

namespace fs = std::filesystem;

/// Copies all files of the project that git has or would take; none where there is no git.
int copy_project(const fs::path& to) {
  const Finished git =
      run_process({.arguments = {"git", "-C", folders().root.string(), "ls-files", "-co", "--exclude-standard"},
                   .output_limit = 16 << 20});
  if (!git.ok()) return 0;
  int copied = 0;
  std::istringstream paths(git.output);
  for (std::string path; std::getline(paths, path);) {
    if (!fs::is_regular_file(folders().root / path)) continue;
    fs::create_directories((to / path).parent_path());
    fs::copy_file(folders().root / path, to / path);
    ++copied;
  }
  return copied;
}

/// The lowest number that no step has.
std::string free_number() {
  int number = 5;
  for (const CourseStep& step : course()) number = std::max(number, std::stoi(step.number()) + 1);
  return (number < 10 ? "0" : "") + std::to_string(number);
}

}  // namespace

TEST_CASE("a new step builds, is judged, and passes its tests", "[new-step]") {
  const TemporaryFolder copy("atelier-new-step");
  if (copy_project(copy.path()) == 0) SKIP_TEST("there is no git to say which files are the project's");
  const auto run = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"env", "-u", "ATELIER_BUILD"});
    const Finished finished = run_process({.arguments = arguments,
                                           .folder = copy.path(),
                                           .time_limit = std::chrono::minutes(50),
                                           .output_limit = 4 << 20});
    INFO(arguments[3] << ": " << finished.output);
    REQUIRE(finished.ok());
    return finished.output;
  };
  const std::string number = free_number(), step = number + "-old-film";
  const std::string made = run({"./atelier", "--yes", "new-step", step, "--title", "Old film"});
  CHECK(mentions(made, {"solutions/" + step + "/old_film.cpp", "./atelier skeleton " + number}));
  run({"./atelier", "skeleton", number});
  run({"./atelier", "reference", number});
  run({"./atelier", "audit", number});
  run({"./atelier", "vary", number});
  run({"./atelier", "measure", number, "--handout"});
  run({"handouts/pictures/make.sh", number});
  run({"docs/pictures/make.sh", number});
  run({"./atelier", "tables"});
  CHECK(mentions(run({"./atelier", "test", "--step", number}), {"stability", " passed, 0 failed"}));
  CHECK(mentions(run({"./atelier", "list"}), {"Old film", "old_film.glsl"}));
}
