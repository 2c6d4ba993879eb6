// Built-in scenes, for steps that get no scene file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// "teapot", "sphere", ...: in menu order.
std::vector<std::string> builtin_scene_names();

/// Builds one. Throws Error listing the known names if `name` is not one of them.
Scene make_builtin_scene(std::string_view name);

}  // namespace atelier
