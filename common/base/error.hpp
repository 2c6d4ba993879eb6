// The exception for an input error that the user can fix.
#pragma once

#include <stdexcept>
#include <string>

namespace atelier {

/// Thrown for any bad input: a broken file, a setting out of range, a missing driver.
/// The message is complete: it names the file, the value, what is allowed and, if possible, what to try next.
/// Programs print it after "error: " on stderr and exit with status 2 (`exit_usage`).
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Exit statuses shared by every program of the project.
inline constexpr int exit_ok = 0;      ///< done, and everything passed
inline constexpr int exit_failed = 1;  ///< done, and something did not pass
inline constexpr int exit_usage = 2;   ///< not done: bad input, one clear message on stderr

}  // namespace atelier
