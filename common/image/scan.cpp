// Checks before two pictures are compared.
#include <algorithm>
#include <cmath>

#include "image/compare.hpp"
#include "image/fast_math.hpp"

namespace atelier {

NonFinite find_non_finite(const Image& image) {
  constexpr std::size_t reported = 10;
  NonFinite result;
  const auto pixels = image.pixels();
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Rgba& p = pixels[i];
    // 0 times a finite number is 0; 0 times NaN or infinity is NaN.
    if (0 * p.r + 0 * p.g + 0 * p.b + 0 * p.a == 0) continue;
    ++result.count;
    if (result.first.size() < reported)
      result.first.push_back({int(i % std::size_t(image.width())), int(i / std::size_t(image.width()))});
  }
  return result;
}

bool is_single_colour(const Image& image, float tolerance) {
  if (image.empty()) return true;
  const Rgba first = image.at(0, 0);
  for (const Rgba& p : image.pixels())
    if (!(std::abs(p.r - first.r) <= tolerance && std::abs(p.g - first.g) <= tolerance &&
          std::abs(p.b - first.b) <= tolerance))
      return false;
  return true;
}

namespace {

/// Number of pixels encoded at a time, channel by channel, for SIMD.
constexpr std::size_t block = 128;

ATELIER_ALSO_FOR_AVX2 void encode_block(float (&channel)[block], float exposure) {
  for (float& value : channel) value = fast::srgb_encode(fast::clamp01(value * exposure));
}

}  // namespace

Image encode_for_comparison(Image linear, float exposure) {
  float values[3][block] = {};
  const auto pixels = linear.pixels();
  for (std::size_t start = 0; start < pixels.size(); start += block) {
    const auto part = pixels.subspan(start, std::min(block, pixels.size() - start));
    for (std::size_t i = 0; i < part.size(); ++i)
      values[0][i] = part[i].r, values[1][i] = part[i].g, values[2][i] = part[i].b;
    for (auto& channel : values) encode_block(channel, exposure);
    for (std::size_t i = 0; i < part.size(); ++i)
      part[i] = {values[0][i], values[1][i], values[2][i], fast::clamp01(part[i].a)};
  }
  return linear;
}

}  // namespace atelier
