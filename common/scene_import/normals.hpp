// Normals for meshes without normals or with invalid ones.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/scene.hpp"

namespace atelier::scene_import {

/// A triangle over a list of positions, and how it shares its normals with its neighbours.
struct Facet {
  std::array<std::uint32_t, 3> corners;
  /// 0: flat. 1 and above: smooth with all neighbours of the same group. -1: not given in the file; smooth with
  /// neighbours at an angle below 60 degrees, so that a box keeps its edges and a bunny is round.
  int smoothing = 0;
};

/// One unit normal for each corner of each facet: the mean of the facets that share it, each weighted by its angle
/// there, so that the triangulation of a polygon does not matter (Thurmer and Wuthrich, "Computing vertex normals from
/// polygonal facets", 1998). +y if none of them has an area.
std::vector<std::array<glm::vec3, 3>> facet_normals(const std::vector<glm::vec3>& positions,
                                                    const std::vector<Facet>& facets);

/// Gives every triangle three vertices of its own with the triangle's normal.
void make_flat(Mesh& mesh);

/// Replaces invalid normals (zero, not finite) by the mean of the adjacent triangles' normals, and normalises all.
/// Returns how many were replaced.
std::size_t fix_normals(Mesh& mesh);

}  // namespace atelier::scene_import
