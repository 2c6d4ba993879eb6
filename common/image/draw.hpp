// Pictures made from pictures, for reports: enlarged details, pictures side by side, differences one can see. All of
// them take and give encoded colours (0..1 is what the screen shows), except where they say otherwise.
#pragma once

#include <span>

#include "image/compare.hpp"
#include "image/image.hpp"

namespace atelier {

struct Box {
  int x = 0, y = 0, width = 0, height = 0;  ///< pixels from the upper left corner
};

/// A box of this size around `centre`, moved where it would leave the picture and made smaller where it does not fit.
Box box_around(const Image& image, Position centre, int width, int height);

/// The pixels in `box`. Throws Error where it is empty or not wholly inside the picture.
Image crop(const Image& image, const Box& box);

/// Each pixel as `factor` x `factor` pixels. Throws Error where factor < 1 or the result is larger than an Image may
/// be.
Image enlarge(const Image& image, int factor);

/// Made smaller by averaging, so that neither side is longer than `longest` (>= 1) pixels and the proportions stay; as
/// it is where it fits already. Every pixel of the result is the mean over exactly the area that it covers.
Image shrink_to(const Image& image, int longest);

/// From left to right, tops aligned, with `gap` pixels between, `background` wherever there is no picture. Throws Error
/// where there are none, one is empty, gap < 0, or the result is larger than an Image may be.
Image side_by_side(std::span<const Image> images, int gap = 4, Rgba background = {1, 1, 1, 1});

/// Grey where equal; 0.5 + gain (yours - reference), clamped to 0..1, channel by channel, opaque. NaN shows as black.
/// Throws Error where the sizes differ.
Image signed_difference(const Image& yours, const Image& reference, float gain = 16);

/// A colour for t = 0..1 (clamped; NaN is 0): black, violet, red, orange, pale yellow. It gets lighter all the way, so
/// that it also reads in grey and to those who see no red or green.
Rgba heat_colour(float t);

/// The red channel of `errors`, as heat colours: `full` (> 0) and above is the lightest.
Image heat_map(const Image& errors, float full = 1);

/// The picture faded to a dim grey, with the pixels of the mask in `colour`. Throws Error where the sizes differ.
Image overlay(const Image& image, const Mask& mask, Rgba colour = {1, 0.1f, 0.6f, 1});

}  // namespace atelier
