// The scenes of a step: a table of names and functions that build them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "case/settings.hpp"
#include "scene/scene.hpp"

namespace atelier {

struct NamedScene {
  std::string name;                            ///< as --scene takes it
  std::function<Scene(const Settings&)> make;  ///< builds it for these settings
};
using SceneTable = std::vector<NamedScene>;  ///< the first is the default

/// A built-in scene (scene/builtin.hpp), under its own name.
NamedScene builtin_scene(const std::string& name);

/// The same scenes, each changed by `adjust` after it is built.
SceneTable adjusted(SceneTable scenes, std::function<void(Scene&, const Settings&)> adjust);

/// Throws Error listing the table's names if `name` is not one of them.
Scene make_scene(const SceneTable& scenes, const std::string& name, const Settings& settings);

}  // namespace atelier
