// Draws a sequence on a fixed clock: a turn round the scene, as an animation or as numbered pictures.
#pragma once

#include <filesystem>

#include "app/picture.hpp"

namespace atelier {

/// `frames` pictures of the camera going once round its target about the up axis, 24 a second. A .gif is one animation;
/// other extensions become NAME-0000.EXT and so on. Throws Error where nothing can be written.
void record_turn(Painter& painter, const Camera& start, const Case& picture, const std::filesystem::path& file,
                 int frames);

}  // namespace atelier
