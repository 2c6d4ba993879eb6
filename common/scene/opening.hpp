// The size of a portal's opening.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.hpp"

namespace atelier {

/// Half the sides of the rectangle around a portal's opening, metres.
inline glm::dvec2 half_size_of(const Scene& scene, const Portal& portal) {
  glm::dvec2 half_size(0);
  for (const Vertex& vertex : scene.meshes[std::size_t(*scene.nodes[std::size_t(portal.node)].mesh)].vertices)
    half_size = glm::max(half_size, glm::abs(glm::dvec2(vertex.position)));
  return half_size;
}

}  // namespace atelier
