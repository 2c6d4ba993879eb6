// The geometry of upright frames, in long double: what the rows of step 12 are held against. A frame is the matrix of
// three unit axes and an origin, in metres, as in the contract; its y axis is that of the world.
#pragma once

#include <glm/glm.hpp>

#include "stability/random.hpp"

namespace atelier::stability {

using Exact = glm::vec<3, long double>;

/// The largest absolute component.
double largest_of(const Exact& v);

/// Turned about y at random, `distance` metres from the origin in any direction.
glm::dmat4 upright_frame(Trial& t, double distance);

/// Each coordinate a multiple of 1/1024 between -size and size.
glm::dvec3 dyadic_place(Trial& t, double size);

/// Turned about y by quarters, at multiples of 1/1024 m.
glm::dmat4 quarter_frame(Trial& t, double size);

Exact axis(const glm::dmat4& frame, int i);
Exact origin(const glm::dmat4& frame);
/// The point at these coordinates of a frame, and the coordinates of a point.
Exact at(const glm::dmat4& frame, const Exact& local);
Exact within(const glm::dmat4& frame, const Exact& p);

/// Where a point comes out that goes in at the entry: turned by half a turn about y, from the one frame to the other.
Exact through(const glm::dmat4& entry, const glm::dmat4& exit, const Exact& p);

/// How far a visitor's box reaches from its centre along a direction: the largest of all corners.
long double reach_along(const Exact& direction);

}  // namespace atelier::stability
