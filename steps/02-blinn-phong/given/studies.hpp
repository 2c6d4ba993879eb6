// Scenes made to be measured rather than looked at: each shows one approximation of this step, and as little else as
// can be. Given.
#pragma once

#include "case/settings.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// A plate that mirrors with colour 1 and nothing else, seen straight from above, under 64 directional lights that
/// stand for a sky of radiance 1: what a pixel shows is the fraction of light that the highlight reflects (its albedo)
/// at normal incidence, and should be 1. By reciprocity light and eye are exchanged: handout, section 4, with u =
/// cos(theta / 2). These lights stand at the nodes of a Gauss-Legendre rule for u from 1/sqrt(2) to 1, which integrates
/// the polynomial there exactly up to an exponent of 124, and beyond as far as floats go.
Scene furnace();

/// The same picture at every exponent, if nothing is rounded: a highlight whose half maximum touches the picture's
/// edges. The light and the eye are straight above a plate, and the angle of view is chosen by the exponent: at most
/// 140 degrees, which is enough from n = 3.5 on. The plate is twice as wide as what is seen, so that its corners lie on
/// whole pixels, and the rasteriser's grid moves nothing.
Scene highlight(float exponent);

/// A plate of `plate.cells` x `plate.cells` squares under a light: what light at the corners alone makes of it.
Scene plate(const Settings& settings);

}  // namespace atelier
