// A bedroom after Vincent van Gogh's "Bedroom in Arles" (1888), in plain shapes. Given.
#pragma once

#include "scene/scene.hpp"

namespace atelier {

/// Adds the bedroom of plan.hpp with its furniture and its lamp, without the door.
void add_bedroom(Scene& scene);

}  // namespace atelier
