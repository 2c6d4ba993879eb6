// The scenes of step @NUMBER@. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

const SceneTable& @NAME@_scenes();

}  // namespace atelier
