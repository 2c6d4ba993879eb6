#include "cli/author/test_tally.hpp"

#include <algorithm>
#include <regex>
#include <string>

namespace atelier {
namespace {

int number(const std::csub_match& match) {
  return match.matched ? std::stoi(match.str()) : 0;
}

/// The last match of `pattern`, which is the summary of the whole run.
bool last_match(std::string_view text, const std::regex& pattern, std::cmatch& match) {
  bool found = false;
  for (std::cregex_iterator it(text.data(), text.data() + text.size(), pattern), end; it != end; ++it) {
    match = *it;
    found = true;
  }
  return found;
}

/// One <testcase ...>...</testcase>.
Tally tally_of_entry(std::string_view entry) {
  if (entry.find("<skipped") != entry.npos || entry.find("status=\"disabled\"") != entry.npos) return {.skipped = 1};
  const bool failed = entry.find("<failure") != entry.npos || entry.find("status=\"fail\"") != entry.npos;
  Tally tally = tally_of_catch2(entry);
  if (failed) tally.failed = std::max(tally.failed, 1);
  if (tally.passed + tally.failed + tally.skipped == 0) tally.passed = 1;
  return tally;
}

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
  passed += other.passed;
  failed += other.failed;
  skipped += other.skipped;
  return *this;
}

Tally tally_of_catch2(std::string_view output) {
  static const std::regex all_passed(R"(All tests passed \(\d+ assertions? in (\d+) test cases?\))");
  static const std::regex some_failed(
      R"(test cases:\s*\d+(?:\s*\|\s*(\d+) passed)?(?:\s*\|\s*(\d+) failed)?(?:\s*\|\s*(\d+) skipped)?)");
  std::cmatch match;
  if (last_match(output, some_failed, match))
    return {.passed = number(match[1]), .failed = number(match[2]), .skipped = number(match[3])};
  if (last_match(output, all_passed, match)) return {.passed = number(match[1])};
  return {};
}

Tally tally_of_junit(std::string_view junit) {
  constexpr std::string_view open = "<testcase ";
  Tally tally;
  for (std::size_t begin = junit.find(open); begin != junit.npos;) {
    const std::size_t next = junit.find(open, begin + open.size());
    tally += tally_of_entry(junit.substr(begin, next - begin));
    begin = next;
  }
  return tally;
}

}  // namespace atelier
