// What the cases ask of step 10's functions. Given.
#pragma once

#include "app/step_program.hpp"

namespace atelier {

std::map<std::string, Probe> style_probes();

}  // namespace atelier
