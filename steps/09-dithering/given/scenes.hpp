// The scenes of step 09. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

const SceneTable& dither_scenes();

}  // namespace atelier
