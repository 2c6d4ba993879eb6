// ./atelier test: runs the tests, in three tiers.
//
//   --quick   the unit tests, and the steps' solutions through the judge
//   (default) all except "long" tests, and the unit tests again under AddressSanitizer and UBSan
//   --all     everything, and the unit tests in a build without unity files and in one by clang++
//   --step    the tests of one step, topic by topic (test_step.cpp)
//
// ctest runs the programs; their labels give the tier (tests/CMakeLists.txt). The launcher has built them.
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstring>
#include <thread>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "cli/author/test_step.hpp"
#include "cli/author/test_tally.hpp"
#include "cli/commands.hpp"
#include "cli/layout.hpp"

extern char** environ;

namespace atelier {
namespace {

namespace fs = std::filesystem;

/// Runs a program attached to our terminal. Returns its exit status, or 128 plus the signal's number, like a shell.
int run_attached(std::vector<std::string> arguments) {
  std::fflush(stdout);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  // Reset signal handling, since ignored signals are inherited.
  sigset_t ours;
  sigemptyset(&ours);
  sigaddset(&ours, SIGPIPE);
  posix_spawnattr_t fresh;
  ::posix_spawnattr_init(&fresh);
  ::posix_spawnattr_setsigdefault(&fresh, &ours);
  ::posix_spawnattr_setflags(&fresh, POSIX_SPAWN_SETSIGDEF);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, pointers[0], nullptr, &fresh, pointers.data(), environ);
  ::posix_spawnattr_destroy(&fresh);
  if (error) throw Error(fmt::format("{} cannot be started: {}", arguments[0], std::strerror(error)));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string jobs() {
  return std::to_string(std::max(1u, std::thread::hardware_concurrency()));
}

/// Runs ctest in a build folder with `selection` (its -L and -LE options).
Tally run_ctest(const fs::path& build, const std::vector<std::string>& selection) {
  const fs::path junit = build / "tests.junit.xml";
  std::error_code none;
  fs::remove(junit, none);  // do not count an old report
  std::vector<std::string> arguments = {"ctest", "--test-dir", build.string(), "--output-on-failure",
                                        "--no-tests=error", "--parallel", jobs(), "--output-junit", junit.string(),
                                        // Full outputs, because their last lines are parsed.
                                        "--test-output-size-passed", "1000000", "--test-output-size-failed", "1000000"};
  arguments.insert(arguments.end(), selection.begin(), selection.end());
  const int status = run_attached(arguments);
  Tally tally = fs::exists(junit) ? tally_of_junit(read_file(junit)) : Tally{};
  if (status != 0 && tally.failed == 0) tally.failed = 1;  // ctest itself failed
  return tally;
}

/// Builds targets of a preset of CMakePresets.json in its own build folder, and runs the tests of a label there. A
/// failed build counts as one failed test.
Tally run_preset(const ProjectFolders& folders, const std::string& preset, const std::vector<std::string>& targets,
                 const std::string& label) {
  const fs::path build = folders.root / "build" / preset;
  const std::string source = folders.root.string();
  if (!fs::exists(build / "build.ninja") &&
      run_attached({"cmake", "-S", source, "--preset", preset, "-B", build.string()}) != 0)
    return {.failed = 1};
  std::vector<std::string> command = {"cmake", "--build", build.string(), "--target"};
  command.insert(command.end(), targets.begin(), targets.end());
  command.insert(command.end(), {"--", "--quiet"});
  if (run_attached(command) != 0) return {.failed = 1};
  return run_ctest(build, {"-L", "^" + label + "$"});
}

bool is_installed(const std::string& program) {
  return run_process({.arguments = {"sh", "-c", "command -v \"$0\"", program}}).ok();
}

std::vector<std::string> selection_of(TestOptions::Tier tier) {
  switch (tier) {
    case TestOptions::Tier::quick:
      return {"-L", "^(unit|quick)$"};
    case TestOptions::Tier::usual:
      return {"-LE", "^long$"};
    case TestOptions::Tier::all:
      return {};
  }
  return {};
}

}  // namespace

int run_test(const TestOptions& options) {
  const ProjectFolders folders = project_folders();
  if (!fs::exists(folders.root / "tests" / "CMakeLists.txt"))
    throw Error("a release has no tests of its own; ./atelier check STEP judges your files");
  const bool all = options.tier == TestOptions::Tier::all;
  if (all) ::setenv("ATELIER_TEST_TURN", "all", 1);  // tests/steps/command.hpp
  const bool one_step = !options.step.empty();
  Tally tally = one_step ? test_step(folders, resolve_step(read_course(folders.step_flags()), options.step))
                         : run_ctest(folders.build, selection_of(options.tier));
  if (!one_step && options.tier != TestOptions::Tier::quick) {
    fmt::print("\n{} under AddressSanitizer and UndefinedBehaviorSanitizer, in build/sanitize\n",
               all ? "All unit tests" : "Unit tests of the judge and of all code that reads input");
    tally += all ? run_preset(folders, "sanitize", {"unit_tests"}, "unit")
                 : run_preset(folders, "sanitize", {"sanitized_unit_tests"}, "reads-input");
  }
  if (all) {
    fmt::print("\nAll files compiled separately, unoptimised, and the unit tests, in build/debug\n");
    tally += run_preset(folders, "debug", {"all", "baselines"}, "unit");
    if (is_installed("clang++")) {
      fmt::print("\nAll files compiled by clang++, and the unit tests, in build/clang\n");
      tally += run_preset(folders, "clang", {"all", "baselines"}, "unit");
    } else {
      fmt::print("\nNot compiled by clang++, which is not installed\n");
      ++tally.skipped;
    }
  }

  if (tally.skipped > 0)
    fmt::print("\n{} passed, {} failed, {} skipped\n", tally.passed, tally.failed, tally.skipped);
  else
    fmt::print("\n{} passed, {} failed\n", tally.passed, tally.failed);
  return tally.failed == 0 ? exit_ok : exit_failed;
}

}  // namespace atelier
