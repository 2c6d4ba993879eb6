// Names the student's function in which a crash happened.
#pragma once

#include <cstddef>

namespace atelier {

/// The qualified name within a mangled one, without its arguments: "atelier::transforms::look_at" from
/// "_ZN7atelier10transforms7look_atERKN3glm...". Empty for other kinds of names (a template, a constructor, an
/// operator) and if it does not fit. Writes at most `capacity` bytes to `name`, without a terminating 0, and returns
/// the length. Async-signal-safe.
std::size_t qualified_name(const char* mangled, char* name, std::size_t capacity);

/// Installs handlers: SIGSEGV, SIGBUS, SIGFPE and SIGILL print one line on stderr before they end the program as usual:
/// "error: in atelier::transforms::look_at (01-transforms)", the innermost function on the stack from a step's library.
/// Without such a function nothing is printed. Works after a stack overflow, but maybe not with a corrupted stack. Does
/// nothing under AddressSanitizer, which reports more.
void name_function_on_crash();

}  // namespace atelier
