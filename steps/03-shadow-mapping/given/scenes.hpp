// The scenes of step 03: each built so that one property of shadows can be seen in it. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

const SceneTable& shadow_scenes();
std::vector<SettingSpec> shadow_scene_settings();

/// The same scene built `factor` times as large (above 0): lengths grow with it, and light falls off with the square of
/// them, so that the picture stays as it is.
void enlarge(Scene& scene, double factor);

/// scene.scale, the factor that a user chooses.
SettingSpec scale_setting();

/// scene.casters: whether nodes cast shadows as the scene says, or all of them do; and what it does.
SettingSpec casters_setting();
void choose_casters(Scene& scene, const Settings& settings);

}  // namespace atelier
