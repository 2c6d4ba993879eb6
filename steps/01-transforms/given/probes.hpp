// Step 01's functions by name, with numbers as arguments and results, as probe cases call them. Given.
#pragma once

#include "app/step_program.hpp"

namespace atelier {

std::map<std::string, Probe> transform_probes();

}  // namespace atelier
