// Step @NUMBER@'s functions by name, on plain numbers, for probe cases. Given.
#pragma once

#include "app/step_program.hpp"

namespace atelier {

std::map<std::string, Probe> @NAME@_probes();

}  // namespace atelier
