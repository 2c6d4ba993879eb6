// The probes of step 07. Given.
#pragma once

#include <map>
#include <string>

#include "app/probe.hpp"

namespace atelier {

std::map<std::string, Probe> portal_probes();

}  // namespace atelier
