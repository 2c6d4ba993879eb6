// Step 01's functions under names, on plain numbers: what probe cases call. Given.
#pragma once

#include "app/step_program.hpp"

namespace atelier {

std::map<std::string, Probe> transform_probes();

}  // namespace atelier
