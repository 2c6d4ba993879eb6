#include "07-stencil-portals/given/body_parts.hpp"

namespace atelier {

std::vector<int> parts_of(const Scene& scene, int body) {
  std::vector<bool> inside(scene.nodes.size(), false);
  std::vector<int> parts;
  for (const int i : parents_first(scene.nodes)) {
    const Node& node = scene.nodes[std::size_t(i)];
    inside[std::size_t(i)] = i == body || (node.parent >= 0 && inside[std::size_t(node.parent)]);
    if (inside[std::size_t(i)] && node.mesh) parts.push_back(i);
  }
  return parts;
}

void add_part(Scene& scene, Node part, const glm::dmat4& to_world, const glm::dvec4& kept) {
  scene.nodes.push_back({.name = part.name + " at the exit", .translation = glm::dvec3(to_world[3])});
  part.parent = int(scene.nodes.size()) - 1;
  part.travels = false;
  part.matrix = glm::mat4(glm::dmat4(glm::dmat3(to_world)));
  part.kept = kept;
  scene.nodes.push_back(std::move(part));
}

}  // namespace atelier
