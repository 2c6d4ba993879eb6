// The scenes of step 03: each built so that one property of shadows can be seen in it. Given.
#pragma once

#include "case/settings.hpp"
#include "scene/scene.hpp"

namespace atelier {

std::vector<std::string> shadow_scene_names();
std::vector<SettingSpec> shadow_scene_settings();

/// A scene as the settings that belong to it shape it. Throws Error for an unknown name.
Scene make_shadow_scene(const std::string& name, const Settings& settings);

/// The same scene built `factor` times as large (above 0): lengths grow with it, and light falls off with the square of
/// them, so that the picture stays as it is.
void enlarge(Scene& scene, double factor);

/// scene.scale, the factor that a user chooses.
SettingSpec scale_setting();

/// scene.casters: whether nodes cast shadows as the scene says, or all of them do; and what it does.
SettingSpec casters_setting();
void choose_casters(Scene& scene, const Settings& settings);

}  // namespace atelier
