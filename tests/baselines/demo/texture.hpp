// Textures as first demos make them.
#pragma once

#include "gl/objects.hpp"
#include "image/image.hpp"

namespace atelier::demo {

/// 32-bit floats with mipmaps, trilinear, repeated.
GlTexture upload(Gl& gl, const Image& picture);

}  // namespace atelier::demo
