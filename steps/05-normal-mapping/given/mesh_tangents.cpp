#include "05-normal-mapping/given/mesh_tangents.hpp"

#include <algorithm>

#include "05-normal-mapping/normal_mapping.hpp"

namespace atelier {

std::vector<glm::vec4> mesh_tangents(const Scene& scene, int mesh, const std::function<bool(const Material&)>& needs) {
  const bool needed = std::any_of(scene.nodes.begin(), scene.nodes.end(), [&](const Node& node) {
    return node.mesh == mesh && needs(scene.materials[std::size_t(node.material)]);
  });
  if (!needed) return {};
  const Mesh& drawn = scene.meshes[std::size_t(mesh)];
  return drawn.tangents.empty() ? normal_mapping::vertex_tangents(drawn) : drawn.tangents;
}

}  // namespace atelier
