// Probes of the functions of step 12. Given.
#pragma once

#include "app/probe.hpp"

namespace atelier {

std::map<std::string, Probe> gallery_probes();

}  // namespace atelier
