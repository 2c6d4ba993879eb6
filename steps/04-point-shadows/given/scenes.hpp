// The scenes of step 04: each built so that one property of shadows all round can be seen in it. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

const SceneTable& point_scenes();
std::vector<SettingSpec> point_scene_settings();

}  // namespace atelier
