// Converts a float texture to 8 or 16 bits per channel: a quarter or half of the memory.
#pragma once

#include "gl/gl.hpp"
#include "image/colour.hpp"

namespace atelier {

/// Converts each level of a 2D float texture to 8 bits per channel: linear light to sRGB codes (GL_SRGB8_ALPHA8), which
/// samplers decode before filtering; everything else unchanged (GL_RGBA8). Values are clamped to 0..1; NaN becomes 0.
/// Filters, wrap modes, the highest level and the texture binding do not change. Does nothing for a texture without
/// levels and for name 0. Throws Error if the texture is not a GL_TEXTURE_2D.
void store_in_8_bits(Gl& gl, GLuint texture, Encoding texels);

/// The same with floats of 16 bits (GL_RGBA16F), whatever the values mean; values beyond 65504 become infinite.
void store_in_16_bits(Gl& gl, GLuint texture);

}  // namespace atelier
