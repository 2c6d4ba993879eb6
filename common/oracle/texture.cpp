#include "oracle/texture.hpp"

#include <algorithm>
#include <cmath>

namespace atelier::oracle {

namespace {

/// The texel at index i of the infinite row that `wrap` makes of `count` texels. i is a double, since it may exceed the
/// range of int.
int wrapped(double i, int count, Wrap wrap) {
  // For a very large i, rounding may give a result outside the period.
  const auto remainder = [&](double period) {
    return int(std::clamp(i - period * std::floor(i / period), 0.0, period - 1));
  };
  if (wrap == Wrap::repeat) return remainder(count);
  if (wrap == Wrap::clamp_to_edge) return int(std::clamp(i, 0.0, double(count - 1)));
  const int place = remainder(2.0 * count);
  return place < count ? place : 2 * count - 1 - place;
}

}  // namespace

glm::dvec3 texel(const Texture& texture, double column, double row) {
  const Image& image = texture.pixels;
  const Rgba& p = image.at(wrapped(column, image.width(), texture.wrap),
                           image.height() - 1 - wrapped(row, image.height(), texture.wrap));
  return {p.r, p.g, p.b};
}

glm::dvec3 texel_colour(const Texture& texture, const glm::dvec2& texcoord) {
  const double x = texcoord.x * texture.pixels.width(), y = texcoord.y * texture.pixels.height();
  if (texture.filter == Filter::nearest) return texel(texture, std::floor(x), std::floor(y));
  const double left = std::floor(x - 0.5), low = std::floor(y - 0.5), right_share = x - 0.5 - left,
               high_share = y - 0.5 - low;
  return glm::mix(glm::mix(texel(texture, left, low), texel(texture, left + 1, low), right_share),
                  glm::mix(texel(texture, left, low + 1), texel(texture, left + 1, low + 1), right_share), high_share);
}

}  // namespace atelier::oracle
