// The hall by given code: what the ground truth is traced with. Given.
#pragma once

#include "12-gallery/given/plan.hpp"

namespace atelier {

HallParts exact_hall(int segments);

}  // namespace atelier
