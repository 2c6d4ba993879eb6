#include "cli/author/test_tally.hpp"

#include "catch.hpp"

using namespace atelier;

TEST_CASE("the summaries of Catch2 versions 2 and 3 are read") {
  struct Row {
    const char *name, *output;
    int passed, failed, skipped;
  };
  const Row rows[] = {
      {"all passed", "====\nAll tests passed (9 assertions in 2 test cases)\n", 2, 0, 0},
      {"one test", "All tests passed (1 assertion in 1 test case)\n", 1, 0, 0},
      {"some failed", "test cases: 3 | 2 passed | 1 failed\nassertions: 9 | 8 passed | 1 failed\n", 2, 1, 0},
      {"all failed", "test cases: 1 | 1 failed\n", 0, 1, 0},
      {"skipped, as version 3 has it", "test cases:  4 |  2 passed | 1 failed | 1 skipped\n", 2, 1, 1},
      {"padded columns", "test cases:  30 |  29 passed |  1 failed\n", 29, 1, 0},
      {"something else", "done\n", 0, 0, 0},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const Tally tally = tally_of_catch2(row.output);
    CHECK(tally.passed == row.passed);
    CHECK(tally.failed == row.failed);
    CHECK(tally.skipped == row.skipped);
  }
}

TEST_CASE("a JUnit file of ctest is counted by test case") {
  const char* const junit = R"(<testsuite tests="5" failures="2">
  <testcase name="unit-a" status="run"><system-out>All tests passed (9 assertions in 4 test cases)</system-out></testcase>
  <testcase name="unit-b" status="fail"><failure message=""/><system-out>test cases: 3 | 2 passed | 1 failed</system-out></testcase>
  <testcase name="crashed" status="fail"><failure message="SEGFAULT"/><system-out>starting</system-out></testcase>
  <testcase name="plain" status="run"><system-out>done</system-out></testcase>
  <testcase name="off" status="disabled"><skipped message="Disabled"/></testcase>
</testsuite>)";
  const Tally tally = tally_of_junit(junit);
  CHECK(tally.passed == 4 + 2 + 1);
  CHECK(tally.failed == 2);
  CHECK(tally.skipped == 1);
  CHECK(tally_of_junit("").passed == 0);
}

TEST_CASE("a program that fails after its tests have passed has failed") {
  const Tally tally = tally_of_junit(
      R"(<testcase name="leaks" status="fail"><failure/><system-out>All tests passed (1 assertion in 1 test case)</system-out></testcase>)");
  CHECK(tally.failed == 1);
}
