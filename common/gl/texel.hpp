// How much memory a texture asks for.
#pragma once

#include <GL/glcorearb.h>

#include <cstdint>

namespace atelier {

/// Bytes of one texel of a sized internal format as its name promises; three channels count as the four that drivers
/// store. 4 for formats that this project does not use.
std::int64_t texel_bytes(GLenum internal_format);

}  // namespace atelier
