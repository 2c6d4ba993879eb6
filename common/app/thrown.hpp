// Describes exceptions of any type.
#pragma once

#include <string>

namespace atelier {

/// "atelier::look_at(...)" from "_ZN7atelier7look_at...", or the unchanged name if it is not mangled.
std::string demangle(const std::string& symbol);

/// The exception being handled: "std::out_of_range was thrown: vector::at", "int was thrown: 42". Includes the text of
/// a std::exception or a string and the value of an int; for other types only the name. Call it only in a catch block
/// or a terminate handler; without a current exception it reports std::terminate.
std::string thrown_in_words();

/// Installs a terminate handler that prints "error: " and the exception on stderr before it aborts (for an exception
/// that leaves a noexcept function, a thread or a static initialiser).
void tell_what_was_thrown_before_aborting();

}  // namespace atelier
