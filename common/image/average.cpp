#include "image/average.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace atelier {
namespace {

/// Summed in double precision, so that the mean of equal pixels is that pixel to the bit.
Rgba mean_of_block(const Image& picture, int left, int top, int factor, bool encoded) {
  double r = 0, g = 0, b = 0, a = 0;
  for (int y = top; y < top + factor; ++y)
    for (int x = left; x < left + factor; ++x) {
      const Rgba& stored = picture.at(x, y);
      const Rgba light = encoded ? srgb_decode(stored) : stored;
      r += light.r, g += light.g, b += light.b, a += light.a;
    }
  const double count = double(factor) * factor;
  const Rgba mean{float(r / count), float(g / count), float(b / count), float(a / count)};
  return encoded ? srgb_encode(mean) : mean;
}

}  // namespace

Image averaged(const Image& picture, int factor, Encoding encoding) {
  if (encoding == Encoding::data) throw Error("a picture of data cannot be averaged: only light can");
  if (factor < 1 || picture.width() % factor || picture.height() % factor)
    throw Error(
        fmt::format("a picture of {} x {} pixels cannot be averaged over {} x {} of them: both sides must be "
                    "multiples of that",
                    picture.width(), picture.height(), factor, factor));
  Image smaller(picture.width() / factor, picture.height() / factor);
  for (int y = 0; y < smaller.height(); ++y)
    for (int x = 0; x < smaller.width(); ++x)
      smaller.at(x, y) = mean_of_block(picture, x * factor, y * factor, factor, encoding == Encoding::srgb);
  return smaller;
}

}  // namespace atelier
