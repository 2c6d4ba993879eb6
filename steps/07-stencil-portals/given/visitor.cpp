#include "07-stencil-portals/given/visitor.hpp"

#include <algorithm>
#include <optional>

#include "07-stencil-portals/given/scenes.hpp"
#include "07-stencil-portals/stencil_portals.hpp"

namespace atelier {

std::vector<SettingSpec> visitor_settings() {
  return {{.name = "visitor.way",
           .fallback = 0.0,
           .low = 0,
           .high = 1,
           .help = "how far the visitor has gone: 0 at the camera, 1 at the end of the scene's walk"}};
}

namespace {

/// Half the sides of the rectangle around an opening's frame.
glm::dvec2 half_size(const Mesh& opening) {
  glm::dvec2 half(0);
  for (const Vertex& vertex : opening.vertices) half = glm::max(half, glm::dvec2(glm::abs(vertex.position)));
  return half;
}

Camera moved(Camera camera, const glm::dvec3& by) {
  camera.eye += by;
  camera.target += by;
  return camera;
}

/// Whether the way from `from` to `to` leads through a portal.
bool enters(const Scene& scene, const Portal& portal, const glm::dmat4& frame, const glm::dvec3& from,
            const glm::dvec3& to) {
  const Node& node = scene.nodes[std::size_t(portal.node)];
  const glm::dvec2 half = half_size(scene.meshes[std::size_t(*node.mesh)]);
  if (stencil_portals::goes_through(frame, half, from, to)) return true;
  if (!scene.materials[std::size_t(node.material)].two_sided) return false;
  // From behind: as from the front of a frame that is turned round.
  const glm::dmat4 half_turn(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1);
  return stencil_portals::goes_through(frame * half_turn, half, from, to);
}

}  // namespace

Camera visit(const Scene& scene, const Camera& camera, const Settings& settings) {
  constexpr int steps = 64;  // of a whole walk
  const double way = settings.real("visitor.way") * steps;
  glm::dvec3 step = walk_of(scene) / double(steps);
  if (way == 0 || step == glm::dvec3(0)) return camera;
  const std::vector<glm::dmat4> world = world_matrices_exact(scene.nodes);
  Camera now = camera;
  std::optional<int> exit;  // whose opening lies behind a visitor who goes straight on, whatever rounding says
  for (int i = 0; i < way; ++i) {
    const Camera next = moved(now, step * std::min(1.0, way - i));
    const auto met = std::ranges::find_if(scene.portals, [&](const Portal& portal) {
      return portal.exit && portal.node != exit &&
             enters(scene, portal, world[std::size_t(portal.node)], now.eye, next.eye);
    });
    now = next;
    if (met == scene.portals.end()) continue;
    exit = met->exit;
    const glm::dmat4 passage =
        stencil_portals::portal_passage(world[std::size_t(met->node)], world[std::size_t(*exit)]);
    now = stencil_portals::carried(now, passage);
    step = glm::dmat3(passage) * step;
  }
  return now;
}

}  // namespace atelier
