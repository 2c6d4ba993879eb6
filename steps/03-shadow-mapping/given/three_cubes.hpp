// A scene for comparison with another program. Given.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace atelier {

/// What LearnOpenGL's demos of shadows have in common: ambient light, background, camera, and material 0, wood.
Scene make_wooden_scene(const std::string& name);

/// The scene of LearnOpenGL's chapter on shadow mapping (Joey de Vries, learnopengl.com): a wooden floor of 50 x 50
/// metres, three wooden boxes of 1, 1 and 0.5 metres over it, and its first view of them. The chapter uses an
/// orthographic map for a point light at (-2, 4, -1); here it is a directional light from there, and the shading is
/// step 02's, so that there is a ground truth. The floor casts no shadow, since nothing is below it.
Scene make_cubes_scene();

}  // namespace atelier
