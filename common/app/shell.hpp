// The shell around every step program: `main` of all of them.
#pragma once

#include "app/load.hpp"

namespace atelier {

/// Reads the command line, loads the step's code and does what was asked. Returns the exit status: what is wrong with
/// the input becomes one line on stderr and status 2. What a student's code throws outside of a case is no bad input:
/// the program says what it was and aborts where it was thrown, so that a debugger stands there.
int run_step(int count, char** arguments, const StepIdentity& identity);

}  // namespace atelier
