// Counts tests as people count them: by test case, not by the programs that hold them.
#pragma once

#include <string_view>

namespace atelier {

struct Tally {
  int passed = 0, failed = 0, skipped = 0;
  Tally& operator+=(const Tally& other);
};

/// The tests in a JUnit file that ctest has written (--output-junit). A program whose output ends with Catch2's summary
/// counts for as many tests as that says; any other for one; one that failed for at least one failed test, whatever it
/// says (it may have crashed).
Tally tally_of_junit(std::string_view junit);

/// Catch2's summary, of either generation: "All tests passed (9 assertions in 2 test cases)" or
/// "test cases: 3 | 2 passed | 1 failed". All zero where `output` has none.
Tally tally_of_catch2(std::string_view output);

}  // namespace atelier
