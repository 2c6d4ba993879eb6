// Step @NUMBER@'s functions under names, on plain numbers: what probe cases call. Given.
#pragma once

#include "app/step_program.hpp"

namespace atelier {

std::map<std::string, Probe> @NAME@_probes();

}  // namespace atelier
