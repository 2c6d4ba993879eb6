// The scenes of step 08. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

const SceneTable& post_scenes();

}  // namespace atelier
