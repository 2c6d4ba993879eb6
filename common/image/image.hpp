// A picture in memory: what the renderer reads back, the judge compares and the reports show.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace atelier {

/// A pixel of four 32-bit floats. For a picture: linear red, green, blue and opacity. For data (a normal, a depth):
/// whatever the producer declares, in the same four slots.
struct Rgba {
  float r = 0, g = 0, b = 0, a = 1;
  bool operator==(const Rgba&) const = default;
};

/// Float RGBA pixels, row 0 at the top, rows from left to right, without padding. Linear unless the user of the image
/// says otherwise. Values are kept as they are: above one, negative, NaN and infinity survive, so that they can be
/// found.
class Image {
 public:
  Image() = default;
  /// Throws atelier::Error where a side is below 1 or above `max_side`.
  Image(int width, int height, Rgba fill = {0, 0, 0, 1});

  Image(const Image&);  // in image.cpp, so that the loop over pixels is optimised whoever copies
  Image& operator=(const Image&);
  Image(Image&&) noexcept = default;
  Image& operator=(Image&&) noexcept = default;
  ~Image() = default;

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return pixels_.empty(); }

  Rgba& at(int x, int y) { return pixels_[std::size_t(y) * width_ + x]; }
  const Rgba& at(int x, int y) const { return pixels_[std::size_t(y) * width_ + x]; }
  std::span<Rgba> pixels() { return pixels_; }
  std::span<const Rgba> pixels() const { return pixels_; }

  bool same_size(const Image& other) const { return width_ == other.width_ && height_ == other.height_; }
  bool operator==(const Image&) const = default;  ///< bit by bit as floats compare: a NaN equals nothing

  static constexpr int max_side = 16384;  ///< pixels a side; the largest target of the software driver

 private:
  int width_ = 0, height_ = 0;
  std::vector<Rgba> pixels_;
};

}  // namespace atelier
