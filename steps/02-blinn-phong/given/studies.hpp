// Scenes for measurements: each isolates one approximation of this step. Given.
#pragma once

#include "case/settings.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// A plate with specular colour 1 and no diffuse colour, seen from straight above, under 64 directional lights that
/// represent a sky of radiance 1: a pixel shows the fraction of light that the highlight reflects (its albedo) at
/// normal incidence, which should be 1. By reciprocity light and eye are exchanged: handout, section 4, with u =
/// cos(theta / 2). The lights are at the nodes of a Gauss-Legendre rule for u from 1/sqrt(2) to 1, which integrates the
/// polynomial there exactly up to an exponent of 124, and above it to float accuracy.
Scene furnace();

/// Shows the same picture for every exponent, except for rounding: a highlight whose half maximum touches the picture's
/// edges. The light and the eye are straight above a plate, and the field of view depends on the exponent: at most 140
/// degrees, which is enough for n >= 3.5. The plate is twice as wide as the view, so that its corners lie on whole
/// pixels and rasterisation does not shift them.
Scene highlight(float exponent);

/// A plate of `plate.cells` x `plate.cells` squares under a light: shows the error of per-vertex lighting.
Scene plate(const Settings& settings);

}  // namespace atelier
