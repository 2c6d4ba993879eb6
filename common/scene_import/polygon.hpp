// Polygons of any shape into triangles.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace atelier::scene_import {

/// Corner numbers of the triangles that fill a polygon: n - 2 of them, wound as it is. Corners may lie somewhat out of
/// one plane; they are seen along the polygon's mean normal. Convex polygons become a fan around corner 0; concave ones
/// are cut by ears (Meisters, "Polygons have ears", 1975) in O(n^2). Where outlines cross themselves or have no area,
/// what comes back still has n - 2 triangles over the same corners.
std::vector<std::array<int, 3>> triangulate(std::span<const glm::vec3> corners);

/// The sum of the cross products of successive corners: its direction is the mean normal, its length twice the area
/// (Newell's method, after Sutherland, Sproull and Schumacker, 1974).
glm::dvec3 newell_normal(std::span<const glm::vec3> corners);

}  // namespace atelier::scene_import
