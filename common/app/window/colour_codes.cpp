#include "app/window/colour_codes.hpp"

#include <algorithm>
#include <cmath>

#include "image/colour.hpp"

namespace atelier {
namespace {

constexpr double most = 1e6;  ///< largest code: an int and, within 1/16, a float can hold it

int code_of(double light) {
  return int(std::lround(std::clamp(255 * srgb_encode(light), -most, most)));
}

}  // namespace

glm::ivec3 codes_of(const Colour& colour) {
  return {code_of(colour.r), code_of(colour.g), code_of(colour.b)};
}

Colour with_codes(const SettingSpec& spec, const Colour& before, const glm::ivec3& codes) {
  Colour colour = before;
  for (int i : {0, 1, 2})
    if (codes[i] != code_of(before[i])) colour[i] = std::clamp(srgb_decode(codes[i] / 255.0), spec.low, spec.high);
  return colour;
}

}  // namespace atelier
