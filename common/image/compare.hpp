// Compares two pictures. No single number is enough, so there are several functions: whether a pixel is not finite,
// whether the picture has a single colour, how many pixels differ and whether they form a blob, and whether the whole
// picture is shifted. The judge decides from the results.
//
// Pictures are compared in red, green and blue; opacity is ignored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "image/image.hpp"

namespace atelier {

struct Position {
  int x = 0, y = 0;  ///< pixels from the upper left corner
  bool operator==(const Position&) const = default;
};

/// One bit a pixel, row 0 at the top.
class Mask {
 public:
  Mask() = default;
  /// Throws Error as Image does.
  Mask(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }
  bool at(int x, int y) const { return bits_[std::size_t(y) * width_ + x] != 0; }
  void set(int x, int y, bool on) { bits_[std::size_t(y) * width_ + x] = on; }
  std::span<std::uint8_t> row(int y) { return {bits_.data() + std::size_t(y) * width_, std::size_t(width_)}; }
  std::span<const std::uint8_t> row(int y) const {
    return {bits_.data() + std::size_t(y) * width_, std::size_t(width_)};
  }
  int count() const;  ///< number of pixels that are on
  bool operator==(const Mask&) const = default;

 private:
  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> bits_;  // 0 or 1, a byte each: faster than vector<bool>
};

/// A pixel is on if its whole 3x3 neighbourhood is on. Pixels outside the picture count as off, so border pixels are
/// always off.
Mask erode(const Mask& mask);

/// Opaque white where the mask is on, opaque black elsewhere.
Image to_image(const Mask& mask);

// --- Before comparing ------------------------------------------------------------------------------------------------

struct NonFinite {
  std::size_t count = 0;        ///< pixels with a NaN or an infinity in red, green, blue or opacity
  std::vector<Position> first;  ///< the first ten of them, in reading order
};
NonFinite find_non_finite(const Image& image);

/// Whether red, green and blue of all pixels are within `tolerance` of the first pixel. True for an empty picture.
bool is_single_colour(const Image& image, float tolerance = 0);

/// The encoding for a display: colours times `exposure`, clamped to 0..1, sRGB-encoded; opacity clamped; NaN becomes 0.
/// Differs from srgb_encode by less than 1e-6, which is 1/4000 of the finest delta (1/255). Works in place: pass the
/// picture with std::move to avoid a copy.
Image encode_for_comparison(Image linear, float exposure = 1);

// --- How far apart ---------------------------------------------------------------------------------------------------

/// How the distance of two pixels is measured.
enum class Measure {
  level,    ///< of encoded colours 0..1: the largest difference of a channel, in 1/255
  degrees,  ///< of directions coded as n/2 + 1/2, of any length: the angle between them, 0..180. A vector shorter than
            ///< 0.02 has no direction (eight bits code zero as 0.004 at best): 0 from another such, 180 from all
            ///< others. Accurate to 0.02 degrees, except from 179 to 180
  number,   ///< of data: the largest difference of a channel, in the data's own unit
};

struct Difference {
  int over = 0;      ///< pixels further apart than delta
  double share = 0;  ///< the same as a share of all, 0..1
  int blob = 0;      ///< pixels over delta after one 3x3 erosion: 0 unless they form a solid block of 3x3 or more
  Position worst;    ///< where the distance is largest; the first of several
  double worst_distance = 0;  ///< there; infinite if one of the two is NaN or infinite
  Mask mask;                  ///< the pixels over delta
};

/// Pixel by pixel. A pixel is over if its distance exceeds `delta` (>= 0, in the measure's unit) by more than float
/// rounding (1/1000 of a level; for numbers 1e-6 relative), or if a channel is NaN or infinite in either picture.
/// Throws Error if sizes differ, a picture is empty, or delta is negative or NaN.
Difference compare_strict(const Image& yours, const Image& reference, Measure measure, double delta);

/// As compare_strict, but a pixel of yours is compared with the range of the 3x3 pixels around it in the reference: per
/// channel from their least to their greatest value; for degrees, with the closest of the nine. So edges may be shifted
/// by up to a pixel; `blob` is more meaningful than `over` here. `worst_distance` is measured from that range.
Difference compare_robust(const Image& yours, const Image& reference, Measure measure, double delta);

// --- Shift of the whole picture
// ------------------------------------------------------------------------------------------------

struct Shift {
  double x = 0, y = 0;  ///< pixels; positive if yours is to the right of and below the reference
  double length() const;
};

/// The displacement that best explains the difference of two pictures: least squares of yours - reference against the
/// mean of their gradients, of (red + green + blue) / 3 (B. D. Lucas and T. Kanade: An Iterative Image Registration
/// Technique, IJCAI 1981, one step). Accurate to about 10 % below half a pixel, and only an indication above one pixel.
/// Pixels that are not finite are left out. If the pictures have no gradient, the shift is 0; if they have none in one
/// direction (stripes), it is 0 in that direction. Throws Error if sizes differ or a picture is empty.
Shift fit_shift(const Image& yours, const Image& reference);

}  // namespace atelier
