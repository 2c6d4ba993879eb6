// Step 06's functions by name, on plain numbers, for probe cases. Given.
#pragma once

#include "app/step_program.hpp"

namespace atelier {

std::map<std::string, Probe> parallax_mapping_probes();

}  // namespace atelier
