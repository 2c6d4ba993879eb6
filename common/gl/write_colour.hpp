// Writes an Image into a target.
#pragma once

#include "gl/target.hpp"

namespace atelier {

/// Writes a picture of the target's size, row 0 at the top, linear light, to its colour; read_colour then returns it,
/// to the precision of the format. Throws Error for another size, for a target that does not own a colour texture or
/// has several samples per pixel.
void write_colour(Gl& gl, const Target& target, const Image& picture);

}  // namespace atelier
