// The scenes of step 02; each shows one part of the model. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

/// The scenes with only the settings of single scenes applied.
const SceneTable& unadjusted_blinn_phong_scenes();

/// The same with the settings of all materials applied.
const SceneTable& blinn_phong_scenes();
std::vector<SettingSpec> blinn_phong_scene_settings();

/// Applies the settings of all scenes: exponents, balance of diffuse and specular colour.
void adjust_materials(Scene& scene, const Settings& settings);

}  // namespace atelier
