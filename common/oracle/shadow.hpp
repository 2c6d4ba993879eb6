// The visible fraction of a light at a point.
//
// Only the visibility is integrated over the light's extent. Amount and direction of the light are those of its centre.
// Filtered shadow maps approximate the same, so any difference from them is a difference in shadow (R. Fernando,
// "Percentage-Closer Soft Shadows", SIGGRAPH 2005 sketches).
//
// The extent, where `shading.shadows` is soft, is a square:
//   spot          side light_width metres, its centre at the light's position, perpendicular to the light's direction;
//                 its sides run along right and up of view_frame(direction, (0, 1, 0))
//   point         the same, perpendicular to the direction from the light to the shaded point
//   directional   of directions: direction + a right + b up, with a and b from -light_width/2 to light_width/2, the
//                 direction of unit length; light_width 0.01 is about half a degree, the sun's
// It is sampled at the centres of light_samples x light_samples equal cells: n samples across an edge that is parallel
// to the grid's rows give an error of at most 1 / (2n).
#pragma once

#include "oracle/shading.hpp"

namespace atelier::oracle {

/// The fraction of the light that reaches the point, 0..1: its visible fraction times `shading.share`. 1 for a point
/// that receives no shadow. The visible fraction is a multiple of 1/n^2 (1 lit, 0 in shadow), and 1 if
/// - `shading` has no shadows, or the light casts none;
/// - the light's position is the point's.
/// Every shadow caster occludes what is behind it, including the point's own surface: a floor sees one half of a light
/// that is halfway below it. If the light's centre is on the back side of the point's surface, visibility is computed
/// on that side; the cosine then removes the light. A surface does not occlude a light that it touches, nor one whose
/// centre lies in its plane: rays start off the surface by 1e-12 of the world's reach and of their own length, and end
/// as much before the light. Throws Error as validate() does, and if `shading.share` returns a value outside 0..1.
/// Ignores `shading.surface`.
double visibility(const World& world, const SurfacePoint& point, const Light& light, const Shading& shading);

/// The same of the image of a light in an opening: 0 where the way to it does not lead through the opening; otherwise
/// what is before the exit, and what is between the entry and the light, occludes it. Only hard shadows: throws Error
/// for soft ones of lights that have a width, if the shading has light that goes through portals. Ignores
/// `shading.share`.
double visibility(const World& world, const SurfacePoint& point, const LightImage& image, const Shading& shading);

}  // namespace atelier::oracle
