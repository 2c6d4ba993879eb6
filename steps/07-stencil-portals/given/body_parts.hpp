// The nodes of a body, and nodes that continue it elsewhere: plain data, without the student's functions. Given.
#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// The nodes with a mesh at or below a node.
std::vector<int> parts_of(const Scene& scene, int body);

/// Adds a node with the same mesh and material at a place in the world, for its part where dot(kept, (p, 1)) >= 0. The
/// translation stays in double precision.
void add_part(Scene& scene, Node part, const glm::dmat4& to_world, const glm::dvec4& kept);

}  // namespace atelier
