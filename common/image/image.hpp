// A picture in memory.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace atelier {

/// A pixel of four 32-bit floats. For a picture: linear red, green, blue and opacity. For data (a normal, a depth):
/// as its producer documents, in the same four components.
struct Rgba {
  float r = 0, g = 0, b = 0, a = 1;
  bool operator==(const Rgba&) const = default;
};

/// Float RGBA pixels, row 0 at the top, rows from left to right, without padding. Linear unless documented otherwise.
/// Any value can be stored, also above 1, negative, NaN and infinity.
class Image {
 public:
  Image() = default;
  /// Throws atelier::Error if a side is below 1 or above `max_side`.
  Image(int width, int height, Rgba fill = {0, 0, 0, 1});

  Image(const Image&);  // in image.cpp, which is compiled with optimisation
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
  bool operator==(const Image&) const = default;  ///< exact float comparison: NaN equals nothing

  static constexpr int max_side = 16384;  ///< pixels a side; the largest target of the software driver

 private:
  int width_ = 0, height_ = 0;
  std::vector<Rgba> pixels_;
};

}  // namespace atelier
