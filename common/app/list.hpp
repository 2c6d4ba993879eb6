// The output of --list: everything that a step program offers.
#pragma once

#include <string>

#include "app/step_program.hpp"

namespace atelier {

std::string list_as_text(const StepDescription& description);
std::string list_as_json(const StepDescription& description);

}  // namespace atelier
