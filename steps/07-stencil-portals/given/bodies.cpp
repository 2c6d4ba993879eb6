#include "07-stencil-portals/given/bodies.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "07-stencil-portals/given/body_parts.hpp"
#include "07-stencil-portals/given/openings.hpp"
#include "07-stencil-portals/stencil_portals.hpp"

namespace atelier {

using namespace stencil_portals;

namespace {

/// The corners of a node's box, in the world.
std::array<glm::dvec3, 8> corners_in_world(const Scene& scene, int node, const glm::dmat4& to_world) {
  return corners_of(box_around(scene.meshes[std::size_t(*scene.nodes[std::size_t(node)].mesh)]), to_world);
}

/// Splits a body's parts at an opening that it stands in, and that it enters from the side where its origin is.
void split(Scene& scene, int body, const std::vector<int>& parts, const std::vector<glm::dmat4>& world,
           const Opening& opening) {
  const glm::dvec3 centre(world[std::size_t(body)][3]);
  const bool behind = opening.two_sided && !before(opening.frame, centre);
  for (const int part : parts) {
    add_part(scene, scene.nodes[std::size_t(part)], opening.passage * world[std::size_t(part)],
             opening_plane(opening.exit, behind));
    scene.nodes[std::size_t(part)].kept = opening_plane(opening.frame, behind);
  }
}

}  // namespace

void split_bodies(Scene& scene) {
  const std::vector<Opening> openings = openings_of(scene);
  const std::vector<glm::dmat4> world = world_matrices_exact(scene.nodes);
  for (int body = 0; body < int(world.size()); ++body) {
    if (!scene.nodes[std::size_t(body)].travels) continue;
    const std::vector<int> parts = parts_of(scene, body);
    for (const Opening& opening : openings) {
      if (opening.mirror) continue;
      // Behind a door that is open on one side a body has not gone through it.
      if (!opening.two_sided && !before(opening.frame, glm::dvec3(world[std::size_t(body)][3]))) continue;
      const bool inside = std::ranges::any_of(parts, [&](int part) {
        return stands_in(opening.frame, opening.half_size, corners_in_world(scene, part, world[std::size_t(part)]));
      });
      if (!inside) continue;
      split(scene, body, parts, world, opening);
      break;  // one opening a body
    }
  }
}

}  // namespace atelier
