// How much of a light a point sees.
//
// Only the share of the light that is seen is integrated over its extent. How much light arrives, and from where, stays
// what the light's centre sends: just what filtered shadow maps approximate, so that a difference from them is a
// difference in shadow (R. Fernando, "Percentage-Closer Soft Shadows", SIGGRAPH 2005 sketches).
//
// The extent, where `shading.shadows` is soft, is a square:
//   spot          of light_width metres a side, its centre at the light's position, square to the light's direction;
//                 its sides run along right and up of view_frame(direction, (0, 1, 0))
//   point         the same, square to the way from the light to the point that is asked about
//   directional   of directions: direction + a right + b up, with a and b from -light_width/2 to light_width/2, the
//                 direction of unit length; light_width 0.01 is about half a degree, the sun's
// It is taken at the middles of light_samples x light_samples equal cells: n samples across an edge that is parallel to
// the grid's rows leave an error of at most 1 / (2n).
#pragma once

#include "oracle/shading.hpp"

namespace atelier::oracle {

/// The share of the light that reaches the point, 0..1: what it sees of the light, times what `shading.share` lets
/// through. It sees a multiple of 1/n^2 (1 lit, 0 in shadow), and 1 where
/// - there are no shadows in `shading`, or the light takes no part in them;
/// - the light's position is the point's.
/// A point that receives no shadow is reached by all of it.
/// Whatever casts shadows hides what is behind it, the point's own surface included: of a light that stands halfway
/// below a floor the floor sees one half. A light whose centre is on the far side of the point's own surface is asked
/// for on that side: whether it reaches this one is for the cosine to say. A surface that touches the light itself does
/// not hide it, and a surface does not hide a light whose centre lies in its plane: rays start 1e-12 of the world's
/// reach and of their own length off the surface, and end as much before the light. Throws Error as validate() does,
/// and where `shading.share` answers with no share. `shading.surface` is not looked at.
double visibility(const World& world, const SurfacePoint& point, const Light& light, const Shading& shading);

}  // namespace atelier::oracle
