// Probes of step 08. Given.
#pragma once

#include "app/probe.hpp"

namespace atelier {

std::map<std::string, Probe> post_probes();

}  // namespace atelier
