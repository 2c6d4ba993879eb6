// The scenes of step 04: each built so that one property of shadows all round can be seen in it. Given.
#pragma once

#include "case/settings.hpp"
#include "scene/scene.hpp"

namespace atelier {

std::vector<std::string> point_scene_names();
std::vector<SettingSpec> point_scene_settings();

/// A scene as the settings that belong to it shape it. Throws Error for an unknown name.
Scene make_point_scene(const std::string& name, const Settings& settings);

}  // namespace atelier
