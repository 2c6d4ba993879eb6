#include "cli/author/test_step.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "base/process.hpp"

namespace atelier {
namespace {

/// The topics of tests/steps/ with tests of single steps, the fastest first. References are not drawn again: that takes
/// as long as all others together, and `solutions` and `truth` judge them.
constexpr const char* topics[] = {"skeletons", "handouts", "required", "solutions",  "audit",  "tiers",
                                  "blind",     "measure",  "truth",    "rewritings", "mutants"};

/// Prints the result of a run and counts its tests: by Catch2's summary, or as one test.
Tally report(const char* topic, const Finished& run) {
  fmt::print("{} {:<11} {:>5.1f} s\n", run.ok() ? "✓" : "✗", topic, run.seconds);
  if (!run.ok()) fmt::print("{}\n", run.output);
  std::fflush(stdout);
  Tally tally = tally_of_catch2(run.output);
  if (tally.passed + tally.failed == 0) tally.passed = run.ok();
  if (!run.ok() && tally.failed == 0) tally.failed = 1;
  return tally;
}

}  // namespace

Tally test_step(const ProjectFolders& folders, const CourseStep& step) {
  ::setenv("ATELIER_TEST_STEP", step.name.c_str(), 1);  // tests/steps/command.hpp
  Tally tally;
  for (const char* topic : topics) {
    const std::string tests = fmt::format("[{}][each-step],[{}][{}]", topic, topic, step.name);
    const Finished run = run_process({.arguments = {(folders.build / "bin" / "steps-tests").string(), tests},
                                      .folder = folders.root,
                                      .output_limit = 16 << 20});
    if (run.output.find("No tests ran") == std::string::npos) tally += report(topic, run);
  }
  if (std::filesystem::exists(folders.build / "bin" / ("stability-" + step.name)))
    tally += report("stability", run_process({.arguments = {(folders.build / "bin" / "atelier").string(), "stability",
                                                            step.name, "--out", (folders.build / "stability").string()},
                                              .output_limit = 16 << 20}));
  return tally;
}

}  // namespace atelier
