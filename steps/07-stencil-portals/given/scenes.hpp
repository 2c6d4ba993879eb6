// The scenes of step 07. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

std::vector<SettingSpec> portal_scene_settings();

/// With bodies that stand in an opening split (bodies.hpp).
const SceneTable& portal_scenes();
/// The same before that.
const SceneTable& whole_portal_scenes();

/// The way of a scene's visitor, from the camera's eye: straight ahead, and through portals where there are some, by
/// the rules of visitor.hpp. Zero where nobody walks.
glm::dvec3 walk_of(const Scene& scene);

}  // namespace atelier
