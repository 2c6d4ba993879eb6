// A scene to compare with others' programs. Given.
#pragma once

#include "scene/scene.hpp"

namespace atelier {

/// The scene of LearnOpenGL's chapter on point shadows (Joey de Vries, learnopengl.com): five wooden boxes in a wooden
/// room of 10 metres, a lamp in its middle whose light does not weaken with the distance, and the chapter's first view.
/// The room casts no shadow: nothing lies behind its walls.
Scene make_cube_room_scene();

}  // namespace atelier
