#include "07-stencil-portals/given/bodies.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "07-stencil-portals/given/openings.hpp"
#include "07-stencil-portals/stencil_portals.hpp"

namespace atelier {

using namespace stencil_portals;

namespace {

/// The nodes with a mesh at or below a node.
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

/// The corners of a node's box, in the world.
std::array<glm::dvec3, 8> corners_in_world(const Scene& scene, int node, const glm::dmat4& to_world) {
  return corners_of(box_around(scene.meshes[std::size_t(*scene.nodes[std::size_t(node)].mesh)]), to_world);
}

/// Adds a node with the same mesh and material at a place in the world. The translation stays in double precision.
void add_copy(Scene& scene, int node, const glm::dmat4& to_world, const glm::dvec4& kept) {
  Node copy = scene.nodes[std::size_t(node)];
  scene.nodes.push_back({.name = copy.name + " at the exit", .translation = glm::dvec3(to_world[3])});
  copy.parent = int(scene.nodes.size()) - 1;
  copy.travels = false;
  copy.matrix = glm::mat4(glm::dmat4(glm::dmat3(to_world)));
  copy.kept = kept;
  scene.nodes.push_back(std::move(copy));
}

/// Splits a body's parts at an opening that it stands in, and that it enters from the side where its origin is.
void split(Scene& scene, int body, const std::vector<int>& parts, const std::vector<glm::dmat4>& world,
           const Opening& opening) {
  const glm::dvec3 centre(world[std::size_t(body)][3]);
  const bool behind = opening.two_sided && !before(opening.frame, centre);
  for (const int part : parts) {
    add_copy(scene, part, opening.passage * world[std::size_t(part)], opening_plane(opening.exit, behind));
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
