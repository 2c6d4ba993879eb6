// Normals for meshes that come without, or with broken ones.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/scene.hpp"

namespace atelier::scene_import {

/// A triangle over a list of positions, and how it shares its normals with its neighbours.
struct Facet {
  std::array<std::uint32_t, 3> corners;
  /// 0: flat, its own. 1 and above: smooth with all neighbours of the same group. -1: the file does not say; smooth
  /// with those neighbours that bend away by less than 60 degrees, so that a box keeps its edges and a bunny is round.
  int smoothing = 0;
};

/// One unit normal for each corner of each facet: the mean of the facets that share it, each weighted by its angle
/// there, so that it does not matter how a polygon was cut into triangles (Thurmer and Wuthrich, "Computing vertex
/// normals from polygonal facets", 1998). Where none of them has an area: +y.
std::vector<std::array<glm::vec3, 3>> facet_normals(const std::vector<glm::vec3>& positions,
                                                    const std::vector<Facet>& facets);

/// Gives every triangle its own three vertices with the triangle's normal.
void make_flat(Mesh& mesh);

/// Replaces normals that are no directions (zero, not finite) by the mean of the triangles around, and scales all to
/// unit length. Returns how many were replaced.
std::size_t mend_normals(Mesh& mesh);

}  // namespace atelier::scene_import
