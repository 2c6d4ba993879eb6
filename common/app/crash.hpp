// A crash, told by the student's function that it happened in: "segmentation fault" alone sends nobody to the right
// line.
#pragma once

#include <cstddef>

namespace atelier {

/// The qualified name within a mangled one, without its arguments: "atelier::transforms::look_at" from
/// "_ZN7atelier10transforms7look_atERKN3glm...". Empty where it is none of that plain kind (a template, a constructor,
/// an operator) or has no room. Writes into `name`, `room` bytes long, without an end mark, and returns its length:
/// what a signal handler may do.
std::size_t qualified_name(const char* mangled, char* name, std::size_t room);

/// From then on a SIGSEGV, SIGBUS, SIGFPE or SIGILL prints one line on stderr before it ends the program as it would
/// have done anyway: "error: in atelier::transforms::look_at (01-transforms)", the innermost function on the stack that
/// lies in a step's library. Without such a function nothing is printed. A stack that has run over is no obstacle; one
/// that was written over may be. Under AddressSanitizer, which tells more, nothing changes.
void name_function_on_crash();

}  // namespace atelier
