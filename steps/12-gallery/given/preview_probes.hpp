// Probes of the functions of step 12 that make, record and choose previews. Given.
#pragma once

#include "app/probe.hpp"

namespace atelier {

std::map<std::string, Probe> preview_probes();

}  // namespace atelier
