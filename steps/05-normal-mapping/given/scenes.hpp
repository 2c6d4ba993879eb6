// The scenes of step 05; each shows one property of normal mapping. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

const SceneTable& normal_mapping_scenes();

/// "ball.segments", "map.size".
std::vector<SettingSpec> normal_mapping_scene_settings();

}  // namespace atelier
