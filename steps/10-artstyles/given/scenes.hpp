// The scenes of step 10. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

const SceneTable& style_scenes();

}  // namespace atelier
