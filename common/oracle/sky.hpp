// The colour of a scene's sky in a direction.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.hpp"

namespace atelier::oracle {

/// Red, green and blue in a direction of world space, of any length except zero: the face that OpenGL selects, and the
/// four texels around the direction interpolated in double precision (OpenGL 3.3 core specification, 3.8.6 and 3.8.7).
/// Seamless: across an edge of the cube the neighbour is a texel of the adjoining face. At a corner of the cube, where
/// three faces meet, the fourth texel is the mean of the other three.
glm::dvec3 sky_colour(const Sky& sky, const glm::dvec3& direction);

}  // namespace atelier::oracle
