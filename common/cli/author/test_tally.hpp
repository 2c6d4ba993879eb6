// Counts test cases, not test programs.
#pragma once

#include <string_view>

namespace atelier {

struct Tally {
  int passed = 0, failed = 0, skipped = 0;
  Tally& operator+=(const Tally& other);
};

/// The tests in a JUnit file of ctest (--output-junit). A program whose output ends with Catch2's summary counts as the
/// tests in it, any other as one; a failed program always counts as at least one failed test (it may have crashed).
Tally tally_of_junit(std::string_view junit);

/// Catch2's summary, of version 2 or 3: "All tests passed (9 assertions in 2 test cases)" or "test cases: 3 | 2 passed
/// | 1 failed". All zero if `output` has none.
Tally tally_of_catch2(std::string_view output);

}  // namespace atelier
