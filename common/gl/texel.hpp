// Nominal memory of a texture.
#pragma once

#include <GL/glcorearb.h>

#include <cstdint>

namespace atelier {

/// Nominal bytes of one texel of a sized internal format; three channels count as four, as drivers store them. 4 for
/// formats that this project does not use.
std::int64_t texel_bytes(GLenum internal_format);

}  // namespace atelier
