// The scenes of step 01: each built so that one function can be seen in it. Given.
#pragma once

#include "case/settings.hpp"
#include "scene/scene.hpp"

namespace atelier {

std::vector<std::string> transform_scene_names();
std::vector<SettingSpec> transform_scene_settings();

/// Throws Error for an unknown name.
Scene make_transform_scene(const std::string& name, const Settings& settings);

}  // namespace atelier
