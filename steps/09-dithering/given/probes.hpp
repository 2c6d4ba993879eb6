// What the cases ask of step 09's functions. Given.
#pragma once

#include "app/step_program.hpp"

namespace atelier {

std::map<std::string, Probe> dither_probes();

}  // namespace atelier
