// Draws a sequence on a fixed clock: a turn round the scene, as an animation or as numbered pictures.
#pragma once

#include <filesystem>

#include "app/picture.hpp"
#include "image/colour.hpp"

namespace atelier {

/// Throws Error, naming the endings allowed, unless `file` ends in .gif, or in .png, .bmp or .exr.
void check_recording(const std::filesystem::path& file);

/// `frames` pictures of the camera going once round its target about the up axis, 24 a second. A .gif is one animation;
/// other files become NAME-0000.EXT and so on. `encoding` is that of the output drawn. Throws Error as
/// check_recording() does, and where nothing can be written.
void record_turn(Painter& painter, const Camera& start, const Case& picture, Encoding encoding,
                 const std::filesystem::path& file, int frames);

}  // namespace atelier
