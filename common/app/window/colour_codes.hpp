// A colour setting in the panel: linear light, shown as 8-bit codes.
#pragma once

#include "case/settings.hpp"

namespace atelier {

/// The nearest sRGB codes of red, green and blue: 255 for light of 1; above 255 for brighter, below 0 for negative
/// light.
glm::ivec3 codes_of(const Colour& colour);

/// `before` after its codes were edited: the exact light of a changed code, clamped to the range of `spec`. A component
/// with an unchanged code keeps its exact value, since many values share a code.
Colour with_codes(const SettingSpec& spec, const Colour& before, const glm::ivec3& codes);

}  // namespace atelier
