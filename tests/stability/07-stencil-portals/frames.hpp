// The geometry of frames, in long double: what the rows of step 07 are held against. Points are taken apart along a
// frame's axes, where the solution multiplies matrices. A frame is the matrix of three unit axes and an origin, in
// metres, as in the contract.
#pragma once

#include <glm/glm.hpp>

#include "stability/random.hpp"

namespace atelier::stability {

using Exact = glm::vec<3, long double>;

/// The largest absolute component.
double largest_of(const Exact& v);

/// Turned at random, `distance` metres from the origin.
glm::dmat4 odd_frame(Trial& t, double distance);

/// Each coordinate a multiple of 1/1024 between -size and size.
glm::dvec3 dyadic_place(Trial& t, double size);

/// At one of the 24 turns by quarters, at multiples of 1/1024 m.
glm::dmat4 quarter_frame(Trial& t, double size);

Exact axis(const glm::dmat4& frame, int i);
Exact origin(const glm::dmat4& frame);
/// The point at these coordinates of a frame.
Exact at(const glm::dmat4& frame, const Exact& local);
/// Metres before the frame's plane.
long double height_above(const glm::dmat4& frame, const Exact& p);

/// What was to the right of the entry's axes by so much is as far to the left of the exit's, and the same for front and
/// back: who goes in backwards along z comes out forwards.
Exact turned_through(const glm::dmat4& entry, const glm::dmat4& exit, const Exact& direction);
Exact through(const glm::dmat4& entry, const glm::dmat4& exit, const Exact& p);
Exact reflected(const glm::dmat4& mirror, const Exact& p);

/// Where a passage takes a point, in double precision.
Exact mapped(const glm::dmat4& passage, const glm::dvec3& p);

/// Of the upper left 3x3, in long double.
double determinant_of(const glm::dmat4& m);

/// The view of a camera that stands as a frame does: right, up and backwards are its axes.
glm::mat4 view_of(const glm::dmat4& camera);

}  // namespace atelier::stability
