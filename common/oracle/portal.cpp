#include "oracle/portal.hpp"

#include <algorithm>

namespace atelier::oracle {

Portals::Portals(const Scene& scene) : by_node_(scene.nodes.size()) {
  if (scene.portals.empty()) return;
  const std::vector<glm::dmat4> world = world_matrices_exact(scene.nodes);
  for (const Portal& portal : scene.portals) {
    // In the entry's frame: half a turn about y to leave the exit at its front, or the reflection of a mirror.
    const glm::dvec3 axes = portal.exit ? glm::dvec3(-1, 1, -1) : glm::dvec3(1, 1, -1);
    glm::dmat4 turn(1);
    for (int i = 0; i < 3; ++i) turn[i][i] = axes[i];
    const glm::dmat4& entry = world[std::size_t(portal.node)];
    const glm::dmat4& exit = world[std::size_t(portal.exit.value_or(portal.node))];
    by_node_[std::size_t(portal.node)] = {portal.colour, exit * turn * glm::inverse(entry)};
  }
}

const Portals::Opening* Portals::at(const SurfacePoint& point) const {
  if (std::size_t(point.thing) >= by_node_.size()) return nullptr;
  const std::optional<Opening>& opening = by_node_[std::size_t(point.thing)];
  return opening ? &*opening : nullptr;
}

Ray beyond(const Portals::Opening& opening, const Ray& ray, double t) {
  // Just behind the opening, so that it does not meet the opening itself, or the exit's, again.
  constexpr double farther = 1 + 1e-12;
  return {glm::dvec3(opening.through * glm::dvec4(ray.origin, 1)),
          glm::dvec3(opening.through * glm::dvec4(ray.direction, 0)), std::max(t * farther, ray.least), ray.most};
}

}  // namespace atelier::oracle
