// The scenes of a step: one table of names and of functions that build them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "case/settings.hpp"
#include "scene/scene.hpp"

namespace atelier {

struct NamedScene {
  std::string name;                            ///< as --scene takes it
  std::function<Scene(const Settings&)> make;  ///< builds it as the settings shape it
};
using SceneTable = std::vector<NamedScene>;  ///< the first is the default

/// A scene that comes with the project (scene/builtin.hpp), under its own name.
NamedScene builtin_scene(const std::string& name);

/// The same scenes, each changed by `adjust` once it is built.
SceneTable adjusted(SceneTable scenes, std::function<void(Scene&, const Settings&)> adjust);

/// Throws Error listing the table's names where `name` is none of them.
Scene make_scene(const SceneTable& scenes, const std::string& name, const Settings& settings);

}  // namespace atelier
