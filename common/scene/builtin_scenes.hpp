// The functions behind the names of builtin.hpp; each returns a scene that passes validate().
#pragma once

#include "scene/scene.hpp"

namespace atelier::builtin {

// Studies of a single object or property.
Scene teapot();      ///< a glazed teapot on a wooden table before a wall, under a point light
Scene sphere();      ///< one sphere on a checker floor
Scene primitives();  ///< each shape of shapes.hpp side by side, textured
Scene materials();   ///< spheres: plastic, copper and gold from dull to sharp highlights
Scene lights();      ///< a white teapot under three coloured spots, a point and a directional light

// Scenes with many objects.
Scene robot();  ///< a figure of boxes and cylinders, nine nodes deep, some children listed before their parents
Scene room();   ///< a room with pictures, a table and a hanging lamp
Scene hall();   ///< a round hall: cylinder wall, floor, ceiling, pedestals

/// A lamp with a shade that hangs from `hook` on a cord of `cord` metres: nodes and a point light of `colour` (radiance
/// at one metre). The nodes cast no shadow, since they would block the light.
void hang_lamp(Scene& scene, const glm::dvec3& hook, float cord, const glm::vec3& colour);

}  // namespace atelier::builtin
