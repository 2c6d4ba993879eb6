// Brings together the code of a step: the libraries of the steps that it stands on, its own, and the given program.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/step_program.hpp"

namespace atelier {

/// What an executable knows about itself.
struct StepIdentity {
  std::string name;                    ///< "03-shadow-mapping"
  std::vector<std::string> libraries;  ///< the steps whose compiled code it calls, in the order of loading
};

/// The search path of somebody at home: the own files of this step where they are built, and for all else the solution
/// where it is there, otherwise the own files again. Roots that do not exist are left out.
Implementations default_implementations(const StepIdentity& identity);

/// The same path, and behind it steps/, where the given shader files of every step are.
Implementations with_given_files(const Implementations& implementations);

/// Loads NN-name/libstep.so of each of the identity's libraries, so that what is loaded later finds their functions.
/// Throws Error where a library is not built yet (saying how to build it) or cannot be loaded.
void load_libraries(const StepIdentity& identity, const Implementations& implementations);

/// Loads the libraries, then the program. Throws Error as load_libraries does, and where a library lacks a function
/// that the contract declares (naming it).
std::unique_ptr<StepProgram> load_step(const StepIdentity& identity, const Implementations& implementations);

}  // namespace atelier
