// Catch2, whichever of its two generations is installed, and the few words that our tests add to it.
//
// Debian 12 has 2.13, one header; Debian 13 has 3.7, many. Tests include this file alone and use TEST_CASE, SECTION,
// REQUIRE, CHECK, INFO, Approx, GENERATE and what stands below.
#pragma once

#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_approx.hpp>
#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

#include <initializer_list>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace atelier::test {

/// The message of the atelier::Error that `action` throws, or an empty string where it throws none. A table of bad
/// inputs then asks for the words that a user must find:
///   CHECK(mentions(error_of([&] { read(file); }), {"cases.json", "size"}));
template <class Action>
std::string error_of(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// Whether each of `words` stands in `text`.
inline bool mentions(std::string_view text, std::initializer_list<std::string_view> words) {
  for (std::string_view word : words)
    if (text.find(word) == std::string_view::npos) return false;
  return true;
}

}  // namespace atelier::test

/// Leaves the running test with a message that always shows: for what this machine does not have (a driver, a display).
/// Catch2 2.13 knows no skipped test, so it counts as one that passed with a warning.
#if defined(SKIP)
#define SKIP_TEST(message) SKIP(message)
#else
#define SKIP_TEST(message)          \
  do {                              \
    WARN("skipped: " << (message)); \
    return;                         \
  } while (false)
#endif
