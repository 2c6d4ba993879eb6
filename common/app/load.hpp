// Loads the code of a step: the libraries of the earlier steps that it uses, its own, and the given program.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/step_program.hpp"

namespace atelier {

/// The step of an executable.
struct StepIdentity {
  std::string name;                    ///< "03-shadow-mapping"
  std::vector<std::string> libraries;  ///< the steps whose compiled code it calls, in the order of loading
};

/// The default search path: the student's files of this step if they are built; for everything else the solution if it
/// exists, otherwise the student's files. Roots that do not exist are left out.
Implementations default_implementations(const StepIdentity& identity);

/// The same path followed by steps/, which has the given shader files of all steps.
Implementations with_given_files(const Implementations& implementations);

/// Loads NN-name/libstep.so of each of the identity's libraries, so that code loaded later finds their functions.
/// Throws Error if a library is not built yet (saying how to build it) or cannot be loaded.
void load_libraries(const StepIdentity& identity, const Implementations& implementations);

/// Loads the libraries, then the program. Throws Error as load_libraries does, and if a library lacks a function that
/// the contract declares (naming it).
std::unique_ptr<StepProgram> load_step(const StepIdentity& identity, const Implementations& implementations);

}  // namespace atelier
