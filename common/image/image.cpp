#include "image/image.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace atelier {

Image::Image(int width, int height, Rgba fill) : width_(width), height_(height) {
  if (width < 1 || height < 1 || width > max_side || height > max_side)
    throw Error(fmt::format("A picture of {} x {} pixels is not possible: each side is 1 to {}.", width, height,
                            int(max_side)));
  pixels_.assign(std::size_t(width) * height, fill);
}

Image::Image(const Image&) = default;
Image& Image::operator=(const Image&) = default;

}  // namespace atelier
