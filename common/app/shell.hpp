// The shell around every step program: `main` of all of them.
#pragma once

#include "app/load.hpp"

namespace atelier {

/// Reads the command line, loads the step's code and does what was asked. Returns the exit status; never throws: what
/// is wrong with the input becomes one line on stderr and status 2.
int run_step(int count, char** arguments, const StepIdentity& identity);

}  // namespace atelier
