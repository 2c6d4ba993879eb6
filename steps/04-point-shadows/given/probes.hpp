// Step 04's functions under names, on plain numbers: what probe cases call. Given.
#pragma once

#include "app/step_program.hpp"

namespace atelier {

std::map<std::string, Probe> point_shadow_probes();

}  // namespace atelier
