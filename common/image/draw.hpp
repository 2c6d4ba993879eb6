// Pictures for reports: enlarged details, pictures side by side, visible differences. All functions take and return
// encoded colours (0..1), unless they say otherwise.
#pragma once

#include <span>

#include "image/compare.hpp"
#include "image/image.hpp"

namespace atelier {

struct Box {
  int x = 0, y = 0, width = 0, height = 0;  ///< pixels from the upper left corner
};

/// A box of this size around `centre`, moved or made smaller so that it lies inside the picture.
Box box_around(const Image& image, Position centre, int width, int height);

/// The pixels in `box`. Throws Error if it is empty or not completely inside the picture.
Image crop(const Image& image, const Box& box);

/// Repeats each pixel `factor` x `factor` times. Throws Error if factor < 1 or the result is larger than an Image may
/// be.
Image enlarge(const Image& image, int factor);

/// Shrinks a picture so that neither side is longer than `longest` (>= 1) pixels; keeps the proportions, and returns a
/// small picture unchanged. Every pixel of the result is the mean over exactly the area that it covers.
Image shrink_to(const Image& image, int longest);

/// From left to right, tops aligned, with `gap` pixels between, on `background`. Throws Error if there are no pictures,
/// one is empty, gap < 0, or the result is larger than an Image may be.
Image side_by_side(std::span<const Image> images, int gap = 4, Rgba background = {1, 1, 1, 1});

/// 0.5 + gain (yours - reference) per channel, clamped to 0..1, opaque: grey where both are equal. NaN becomes black.
/// Throws Error if the sizes differ.
Image signed_difference(const Image& yours, const Image& reference, float gain = 16);

/// A colour for t = 0..1 (clamped; NaN is 0): black, violet, red, orange, pale yellow. Lightness always increases, so
/// it can also be read in grey and by colour-blind people.
Rgba heat_colour(float t);

/// The red channel of `errors` as heat colours: `full` (> 0) and above is the lightest.
Image heat_map(const Image& errors, float full = 1);

/// The picture in dark grey, with the pixels of the mask in `colour`. Throws Error if the sizes differ.
Image overlay(const Image& image, const Mask& mask, Rgba colour = {1, 0.1f, 0.6f, 1});

}  // namespace atelier
