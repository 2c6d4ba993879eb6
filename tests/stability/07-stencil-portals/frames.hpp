// Frames of any direction, mirrors and cameras: what else the rows of step 07 are held against.
#pragma once

#include <glm/glm.hpp>

#include "stability/frames.hpp"

namespace atelier::stability {

/// Turned at random, `distance` metres from the origin.
glm::dmat4 odd_frame(Trial& t, double distance);

/// At one of the 24 turns by quarters, at multiples of 1/1024 m.
glm::dmat4 quarter_frame(Trial& t, double size);

/// Metres before the frame's plane.
long double height_above(const glm::dmat4& frame, const Exact& p);

Exact reflected(const glm::dmat4& mirror, const Exact& p);

/// Where a passage takes a point, in double precision.
Exact mapped(const glm::dmat4& passage, const glm::dvec3& p);

/// Of the upper left 3x3, in long double.
double determinant_of(const glm::dmat4& m);

/// The view of a camera that stands as a frame does: right, up and backwards are its axes.
glm::mat4 view_of(const glm::dmat4& camera);

}  // namespace atelier::stability
