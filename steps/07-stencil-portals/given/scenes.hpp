// The scenes of step 07. Given.
#pragma once

#include "app/scene_table.hpp"

namespace atelier {

const SceneTable& portal_scenes();

/// The way of a scene's visitor, from the camera's eye: straight ahead, and through portals where there are some. Zero
/// where nobody walks.
glm::dvec3 walk_of(const Scene& scene);

}  // namespace atelier
