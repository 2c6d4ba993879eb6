// A picture of exact codes, on which every method of dithering has one right result on each machine. Given.
#pragma once

#include <glm/glm.hpp>

#include "image/image.hpp"

namespace atelier {

inline constexpr glm::ivec2 card_size{160, 120};

/// A sunset by the sea, with whole numbers only: the linear values of its sRGB codes, which have noise of a few codes
/// so that no part of it is flat.
Image make_card();

}  // namespace atelier
