// The scenes of step 03; each shows one property of shadows. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

const SceneTable& shadow_scenes();
std::vector<SettingSpec> shadow_scene_settings();

/// A teapot on a table in front of a wall, under one spot: the scene `teapot`, and of later steps.
Scene make_teapot_scene();

/// Scales a scene by `factor` (above 0): lengths and the lights' attenuation, so that the picture does not change.
void enlarge(Scene& scene, double factor);

/// The setting scene.scale.
SettingSpec scale_setting();

/// The setting scene.casters (whether only flagged nodes cast shadows, or all), and the function that applies it.
SettingSpec casters_setting();
void choose_casters(Scene& scene, const Settings& settings);

}  // namespace atelier
