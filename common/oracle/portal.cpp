#include "oracle/portal.hpp"

#include <algorithm>

namespace atelier::oracle {

glm::dmat4 passage_of(const Portal& portal, const std::vector<glm::dmat4>& world) {
  // In the entry's frame: half a turn about y to leave the exit at its front, or the reflection of a mirror.
  const glm::dvec3 axes = portal.exit ? glm::dvec3(-1, 1, -1) : glm::dvec3(1, 1, -1);
  glm::dmat4 turn(1);
  for (int i = 0; i < 3; ++i) turn[i][i] = axes[i];
  return world[std::size_t(portal.exit.value_or(portal.node))] * turn * glm::inverse(world[std::size_t(portal.node)]);
}

Portals::Portals(const Scene& scene) : by_node_(scene.nodes.size()) {
  if (scene.portals.empty()) return;
  const std::vector<glm::dmat4> world = world_matrices_exact(scene.nodes);
  for (const Portal& portal : scene.portals)
    by_node_[std::size_t(portal.node)] = {portal.colour, passage_of(portal, world)};
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
