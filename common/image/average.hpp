// Shrinks a picture by averaging.
#pragma once

#include "image/colour.hpp"
#include "image/image.hpp"

namespace atelier {

/// Each pixel is the mean of `factor` x `factor` pixels of `picture` (a box filter). Averages linear light: sRGB codes
/// are decoded first and then encoded again; opacity is averaged directly. NaN and infinity propagate into the mean.
/// Throws Error if the factor is below 1 or does not divide both sides, or if the picture is data.
Image averaged(const Image& picture, int factor, Encoding encoding);

}  // namespace atelier
