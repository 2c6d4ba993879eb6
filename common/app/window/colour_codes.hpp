// A colour as the panel shows it: a setting is linear light, and people know colours by their 8-bit codes.
#pragma once

#include "case/settings.hpp"

namespace atelier {

/// The nearest sRGB codes of red, green and blue: 255 for light of 1; above that for more, below 0 for less than none.
glm::ivec3 codes_of(const Colour& colour);

/// `before` after its codes were edited: exactly the light that a new code stands for, within the range of `spec`. A
/// component whose code has stayed keeps its light to the last digit, since many lights share a code.
Colour with_codes(const SettingSpec& spec, const Colour& before, const glm::ivec3& codes);

}  // namespace atelier
