// Upright frames, and the reach of a visitor: what else the rows of step 12 are held against.
#pragma once

#include <glm/glm.hpp>

#include "stability/frames.hpp"

namespace atelier::stability {

/// Turned about y at random, `distance` metres from the origin in any direction.
glm::dmat4 upright_frame(Trial& t, double distance);

/// Turned about y by quarters, at multiples of 1/1024 m.
glm::dmat4 quarter_frame(Trial& t, double size);

/// How far a visitor's box reaches from its centre along a direction: the largest of all corners.
long double reach_along(const Exact& direction);

}  // namespace atelier::stability
