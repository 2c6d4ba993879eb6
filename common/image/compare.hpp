// Are two pictures the same? No single number can say, so the answer comes in layers, each a function of its own:
// is anything in the answer not a number, is it one colour all over, how many pixels are off and do they form a blob,
// and has the picture moved as a whole. What follows from them is decided elsewhere.
//
// Pictures are compared in red, green and blue; opacity is not looked at.
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
  int count() const;  ///< how many are on
  bool operator==(const Mask&) const = default;

 private:
  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t>
      bits_;  // 0 or 1; a byte each, since neighbouring bits of a vector<bool> cannot be compared fast
};

/// On where the whole 3x3 neighbourhood is on. Outside the picture nothing is on, so the outermost pixels never stay.
Mask erode(const Mask& mask);

/// Opaque white where the mask is on, opaque black elsewhere.
Image to_image(const Mask& mask);

// --- Before comparing ------------------------------------------------------------------------------------------------

struct NonFinite {
  std::size_t count = 0;        ///< pixels with a NaN or an infinity in red, green, blue or opacity
  std::vector<Position> first;  ///< the first ten of them, in reading order
};
NonFinite find_non_finite(const Image& image);

/// Whether red, green and blue are the same in all pixels, to within `tolerance` of the first one. An empty picture is.
bool is_single_colour(const Image& image, float tolerance = 0);

/// What a screen would be sent: colours times `exposure`, clamped to 0..1, sRGB-encoded; opacity clamped. NaN becomes
/// 0. Off by less than 1e-6 from srgb_encode: a four-thousandth of the finest step that anyone compares (1/255).
/// Works in place: hand over with std::move what is not needed any more, and nothing is copied.
Image encode_for_comparison(Image linear, float exposure = 1);

// --- How far apart ---------------------------------------------------------------------------------------------------

/// What the distance of two pixels is measured in.
enum class Measure {
  level,    ///< of encoded colours 0..1: the largest difference of a channel, in 1/255
  degrees,  ///< of directions coded as n/2 + 1/2, of any length: the angle between them, 0..180. A vector shorter than
            ///< 0.02 has no direction (eight bits code zero as 0.004 at best): 0 from another such, 180 from all
            ///< others. Good to 0.02 degrees, but for the last degree before 180
  number,   ///< of data: the largest difference of a channel, in the data's own unit
};

struct Difference {
  int over = 0;      ///< pixels further apart than delta
  double share = 0;  ///< the same as a share of all, 0..1
  int blob = 0;      ///< pixels over that remain after one 3x3 erosion: 0 unless they form a solid patch of 3x3 or more
  Position worst;    ///< where the distance is largest; the first of several
  double worst_distance = 0;  ///< there; infinite where one of the two is not a number
  Mask mask;                  ///< the pixels over
};

/// Pixel by pixel. A pixel is over where its distance is larger than `delta` (>= 0, in the measure's unit) by more than
/// the rounding of the floats that hold it (a thousandth of a level; for numbers a relative 1e-6), or where a channel
/// is NaN or infinite in one of the two. Throws Error where sizes differ, a picture is empty or delta is negative or
/// NaN.
Difference compare_strict(const Image& yours, const Image& reference, Measure measure, double delta);

/// As compare_strict, but a pixel of yours may lie anywhere within delta of what the 3x3 pixels around it in the
/// reference span: channel by channel between their least and greatest value, or, for degrees, near one of the nine. So
/// edges may lie up to a pixel elsewhere; `blob` tells more than `over` here. `worst_distance` is measured from that
/// span.
Difference compare_robust(const Image& yours, const Image& reference, Measure measure, double delta);

// --- Moved as a whole ------------------------------------------------------------------------------------------------

struct Shift {
  double x = 0, y = 0;  ///< pixels; positive where yours lies further right and further down than the reference
  double length() const;
};

/// The displacement that explains the difference of two pictures best: least squares of yours - reference against the
/// mean of their gradients, of red + green + blue over three (B. D. Lucas and T. Kanade: An Iterative Image
/// Registration Technique, IJCAI 1981, one step). Good to about a tenth of its length below half a pixel, and only a
/// sign of trouble above one. Pixels that are not finite are left out. Where the pictures have no gradient, or none in
/// one direction (stripes), the shift is 0 (along the stripes). Throws Error where sizes differ or a picture is empty.
Shift fit_shift(const Image& yours, const Image& reference);

}  // namespace atelier
