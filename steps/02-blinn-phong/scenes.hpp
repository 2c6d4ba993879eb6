// The scenes of step 02: each built so that one part of the model can be seen in it. Given.
#pragma once

#include "case/settings.hpp"
#include "scene/scene.hpp"

namespace atelier {

std::vector<std::string> blinn_phong_scene_names();
std::vector<SettingSpec> blinn_phong_scene_settings();

/// A scene as its author wrote it, and as the settings that belong to it alone shape it. Throws Error for an unknown
/// name.
Scene unadjusted_blinn_phong_scene(const std::string& name, const Settings& settings);

/// The same with the settings' changes. Throws Error for an unknown name.
Scene make_blinn_phong_scene(const std::string& name, const Settings& settings);

/// What the settings change of any scene: exponents, balance of diffuse and specular colour.
void adjust_materials(Scene& scene, const Settings& settings);

}  // namespace atelier
