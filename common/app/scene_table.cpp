#include "app/scene_table.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/near_names.hpp"
#include "scene/builtin.hpp"

namespace atelier {

NamedScene builtin_scene(const std::string& name) {
  return {name, [name](const Settings&) { return make_builtin_scene(name); }};
}

SceneTable adjusted(SceneTable scenes, std::function<void(Scene&, const Settings&)> adjust) {
  for (NamedScene& scene : scenes)
    scene.make = [make = std::move(scene.make), adjust](const Settings& settings) {
      Scene made = make(settings);
      adjust(made, settings);
      return made;
    };
  return scenes;
}

Scene make_scene(const SceneTable& scenes, const std::string& name, const Settings& settings) {
  std::vector<std::string> known;
  for (const NamedScene& scene : scenes) {
    if (scene.name == name) return scene.make(settings);
    known.push_back(scene.name);
  }
  const std::string nearest = nearest_name(name, known);
  const bool is_file = name.find('.') != name.npos;
  throw Error(fmt::format("scene '{}': this program has {}{}{}", name, join(known),
                          is_file ? "; model files are .gltf, .glb and .obj" : "",
                          nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest)));
}

}  // namespace atelier
