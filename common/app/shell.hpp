// The shell of all step programs: their `main`.
#pragma once

#include "app/load.hpp"

namespace atelier {

/// Reads the command line, loads the step's code and runs it. Returns the exit status: bad input gives one line on
/// stderr and status 2. An exception of a student's code outside of a case is reported, and the program aborts where it
/// was thrown, so that a debugger stops there.
int run_step(int count, char** arguments, const StepIdentity& identity);

}  // namespace atelier
