#include "07-stencil-portals/given/openings.hpp"

#include <algorithm>

#include "07-stencil-portals/stencil_portals.hpp"

namespace atelier {

using namespace stencil_portals;

std::array<glm::dvec4, 4> Opening::corners() const {
  const auto corner = [&](double x, double y) { return frame * glm::dvec4(x * half_size.x, y * half_size.y, 0, 1); };
  return {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
}

std::vector<Opening> openings_of(const Scene& scene) {
  std::vector<Opening> openings;
  if (scene.portals.empty()) return openings;
  const std::vector<glm::dmat4> world = world_matrices_exact(scene.nodes);
  for (const Portal& portal : scene.portals) {
    const Node& node = scene.nodes[std::size_t(portal.node)];
    Opening opening{.node = portal.node, .exit_node = portal.exit.value_or(portal.node), .mirror = !portal.exit};
    opening.frame = world[std::size_t(opening.node)];
    opening.exit = world[std::size_t(opening.exit_node)];
    opening.passage = opening.mirror ? mirror_passage(opening.frame) : portal_passage(opening.frame, opening.exit);
    opening.two_sided = scene.materials[std::size_t(node.material)].two_sided;
    opening.colour = portal.colour;
    for (const Vertex& vertex : scene.meshes[std::size_t(*node.mesh)].vertices)
      opening.half_size = glm::max(opening.half_size, glm::abs(glm::dvec2(vertex.position)));
    openings.push_back(opening);
  }
  return openings;
}

glm::dmat4 from_behind(const glm::dmat4& frame) {
  return {-frame[0], frame[1], -frame[2], frame[3]};
}

bool before(const glm::dmat4& frame, const glm::dvec3& point) {
  return glm::dot(glm::dvec3(frame[2]), point - glm::dvec3(frame[3])) >= 0;
}

bool beyond_far_plane(std::span<const glm::dvec4> points, const Viewpoint& viewpoint) {
  return std::ranges::all_of(points, [&](const glm::dvec4& point) {
    const glm::vec4 seen = viewpoint.world_to_view * glm::vec4(glm::dvec3(point) - viewpoint.origin, 1);
    return -seen.z > viewpoint.view.camera.far;
  });
}

}  // namespace atelier
