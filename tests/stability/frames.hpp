// The geometry of frames, in long double: what the rows of steps whose frames are doors are held against. Points are
// taken apart along a frame's axes, where solutions multiply matrices. A frame is the matrix of three unit axes and an
// origin, in metres, as in the contracts.
#pragma once

#include <glm/glm.hpp>

#include "stability/random.hpp"
#include "stability/table.hpp"

namespace atelier::stability {

using Exact = glm::vec<3, long double>;

inline constexpr double double_unit = 0x1p-53;  ///< what one rounding of a double may cost, relative to the result
inline constexpr double million = 1e6;

/// A few roundings of coordinates of this size, in metres.
Bound metres(double size, const char* reason);

/// The largest absolute component.
double largest_of(const Exact& v);

/// Each coordinate a multiple of 1/1024 between -size and size.
glm::dvec3 dyadic_place(Trial& t, double size);

Exact axis(const glm::dmat4& frame, int i);
Exact origin(const glm::dmat4& frame);
/// The point at these coordinates of a frame, and the coordinates of a point.
Exact at(const glm::dmat4& frame, const Exact& local);
Exact within(const glm::dmat4& frame, const Exact& p);

/// Where a point or a direction comes out that goes in at the entry: what was to the right of the entry's axes by so
/// much is as far to the left of the exit's, and the same for front and back.
Exact through(const glm::dmat4& entry, const glm::dmat4& exit, const Exact& p);
Exact turned_through(const glm::dmat4& entry, const glm::dmat4& exit, const Exact& direction);

}  // namespace atelier::stability
