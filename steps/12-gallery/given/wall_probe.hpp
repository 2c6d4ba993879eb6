// A probe of the hall's wall that any triangles pass which make it. Given.
#pragma once

#include "app/probe.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// What rays from the axis meet, in the directions `angles` (radians clockwise seen from above, from +z) at the heights
/// `heights` (metres), a pair each: how many triangles, and of the first one the distance, whether its front is seen,
/// and normal and texture coordinate there; seven zeros if none is met. Then the area of all triangles.
Numbers seen_from_axis(const Mesh& wall, const std::vector<double>& angles, const std::vector<double>& heights);

}  // namespace atelier
