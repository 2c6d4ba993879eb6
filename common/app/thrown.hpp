// What somebody's code has thrown, in words: an exception must be told apart from an answer, whatever its type.
#pragma once

#include <string>

namespace atelier {

/// "atelier::look_at(...)" from "_ZN7atelier7look_at...", or the name as it is where it is no mangled one.
std::string demangle(const std::string& symbol);

/// The exception that is being handled: "std::out_of_range was thrown: vector::at", "int was thrown: 42". The text of a
/// std::exception, of a string and of an int is given; of other types the name alone. Call it in a catch block or a
/// terminate handler only; where nothing is being handled, it says that the program gave up.
std::string thrown_in_words();

/// Has a program that nothing can save (an exception that leaves a noexcept function, a thread, a static initialiser)
/// say "error: " and what was thrown on stderr before it aborts.
void tell_what_was_thrown_before_aborting();

}  // namespace atelier
