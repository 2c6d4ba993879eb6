// A texture in a quarter of the memory.
#pragma once

#include "gl/gl.hpp"
#include "image/colour.hpp"

namespace atelier {

/// Stores each level of a 2D texture anew in 8 bits a channel, from the floats that it holds: linear light as sRGB
/// codes (GL_SRGB8_ALPHA8), which samplers decode before they filter; all else as it is (GL_RGBA8). Both end at 0 and
/// 1; what is no number becomes 0. Filters, wrap modes and the highest level stay, and so does what is bound. A texture
/// without levels, and the name 0, are left as they are. Throws Error where the texture is none of GL_TEXTURE_2D.
void store_in_8_bits(Gl& gl, GLuint texture, Encoding texels);

}  // namespace atelier
