// The way of a picture back into a target.
#pragma once

#include "gl/target.hpp"

namespace atelier {

/// Fills the colour of a target with a picture of its size, row 0 at the top, linear light: what read_colour then
/// returns, to the precision of the format. Throws Error for another size, for a target without a colour of its own
/// or with several samples a pixel.
void write_colour(Gl& gl, const Target& target, const Image& picture);

}  // namespace atelier
