// A picture made smaller by taking means.
#pragma once

#include "image/colour.hpp"
#include "image/image.hpp"

namespace atelier {

/// Each pixel the mean of `factor` x `factor` pixels of `picture` (a box filter). The mean is of light: sRGB codes are
/// decoded before it and encoded again; opacity is averaged as it is. What is no number or infinite makes the mean so.
/// Throws Error where the factor is below 1 or does not divide both sides, and where the picture is data, whose means
/// mean nothing.
Image averaged(const Image& picture, int factor, Encoding encoding);

}  // namespace atelier
