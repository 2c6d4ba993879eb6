// The scenes of step 02: each built so that one part of the model can be seen in it. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

/// Scenes as their authors wrote them, and as the settings that belong to one alone shape it.
const SceneTable& unadjusted_blinn_phong_scenes();

/// The same with the settings' changes to all materials.
const SceneTable& blinn_phong_scenes();
std::vector<SettingSpec> blinn_phong_scene_settings();

/// What the settings change of any scene: exponents, balance of diffuse and specular colour.
void adjust_materials(Scene& scene, const Settings& settings);

}  // namespace atelier
