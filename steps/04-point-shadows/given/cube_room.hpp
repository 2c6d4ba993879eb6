// A scene for comparison with another program. Given.
#pragma once

#include "scene/scene.hpp"

namespace atelier {

/// The scene of LearnOpenGL's chapter on point shadows (Joey de Vries, learnopengl.com): five wooden boxes in a wooden
/// room of 10 metres, a point light without attenuation in its middle, and the chapter's first view. The room casts no
/// shadow, since nothing is behind its walls.
Scene make_cube_room_scene();

}  // namespace atelier
