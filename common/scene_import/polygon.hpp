// Triangulates polygons of any shape.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace atelier::scene_import {

/// Corner indices of the n - 2 triangles that fill a polygon, with its winding. Corners need not be exactly coplanar;
/// they are projected along the polygon's mean normal. Convex polygons become a fan around corner 0; concave ones are
/// triangulated by ear clipping (Meisters, "Polygons have ears", 1975) in O(n^2). Self-intersecting outlines and those
/// without area also give n - 2 triangles over the same corners.
std::vector<std::array<int, 3>> triangulate(std::span<const glm::vec3> corners);

/// The sum of the cross products of successive corners: its direction is the mean normal, its length twice the area
/// (Newell's method, after Sutherland, Sproull and Schumacker, 1974).
glm::dvec3 newell_normal(std::span<const glm::vec3> corners);

}  // namespace atelier::scene_import
