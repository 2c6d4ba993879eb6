#include <numeric>

#include "image/compare.hpp"

namespace atelier {

Mask::Mask(int width, int height) : width_(width), height_(height) {
  if (width < 1 || height < 1 || width > Image::max_side || height > Image::max_side)
    Image(width, height);  // checks the size
  bits_.assign(std::size_t(width) * height, 0);
}

int Mask::count() const {
  return std::accumulate(bits_.begin(), bits_.end(), 0);
}

Mask erode(const Mask& mask) {
  if (mask.width() < 3 || mask.height() < 3) return mask.width() ? Mask(mask.width(), mask.height()) : Mask();
  Mask result(mask.width(), mask.height());
  for (int y = 1; y < mask.height() - 1; ++y) {
    const auto above = mask.row(y - 1), here = mask.row(y), below = mask.row(y + 1);
    const auto column = [&](std::size_t x) { return above[x] & here[x] & below[x]; };
    const auto out = result.row(y);
    for (std::size_t x = 1; x + 1 < out.size(); ++x) out[x] = std::uint8_t(column(x - 1) & column(x) & column(x + 1));
  }
  return result;
}

Image to_image(const Mask& mask) {
  if (mask.width() == 0) return {};
  Image result(mask.width(), mask.height());
  for (int y = 0; y < mask.height(); ++y)
    for (int x = 0; x < mask.width(); ++x)
      if (mask.at(x, y)) result.at(x, y) = {1, 1, 1, 1};
  return result;
}

}  // namespace atelier
