// The system's reason for a failure, in words.
#pragma once

#include <cerrno>
#include <string>
#include <system_error>

namespace atelier {

/// "No such file or directory" for ENOENT; by default for the last error of this thread.
inline std::string system_reason(int number = errno) {
  return std::generic_category().message(number);
}

}  // namespace atelier
