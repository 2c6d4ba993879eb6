// Scenes that come with the project: what a step shows when no file is given.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// "teapot", "sphere", ...: in the order in which a menu should list them.
std::vector<std::string> builtin_scene_names();

/// Builds one. Throws Error listing the known names where `name` is none of them.
Scene make_builtin_scene(std::string_view name);

}  // namespace atelier
