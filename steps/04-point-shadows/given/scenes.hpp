// The scenes of step 04; each shows one property of omnidirectional shadows. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

const SceneTable& point_scenes();
std::vector<SettingSpec> point_scene_settings();

}  // namespace atelier
