#include "07-stencil-portals/given/bodies_truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "07-stencil-portals/given/body_parts.hpp"
#include "oracle/portal.hpp"
#include "scene/opening.hpp"

namespace atelier {

namespace {

/// The plane z = 0 of a frame, positive where its +z points, or where -z points.
glm::dvec4 plane_of(const glm::dmat4& frame, bool turned) {
  const glm::dvec3 normal = turned ? -glm::dvec3(frame[2]) : glm::dvec3(frame[2]);
  return {normal, -glm::dot(normal, glm::dvec3(frame[3]))};
}

/// The points where the edges of a box cross the plane z = 0; none if all corners are on one side.
std::vector<glm::dvec2> section(const Box3& box, const glm::dmat4& to_frame) {
  const std::array<glm::dvec3, 8> corners = corners_of(box, to_frame);
  std::vector<glm::dvec2> points;
  for (int from = 0; from < 8; ++from)
    for (const int axis : {1, 2, 4}) {
      if (from & axis) continue;
      const glm::dvec3 &a = corners[std::size_t(from)], &b = corners[std::size_t(from | axis)];
      if ((a.z < 0) != (b.z < 0)) points.push_back(glm::dvec2(a + (b - a) * (a.z / (a.z - b.z))));
    }
  glm::dvec2 centre(0);
  for (const glm::dvec2& point : points) centre += point / double(points.size());
  std::ranges::sort(points, {}, [&](const glm::dvec2& p) { return std::atan2(p.y - centre.y, p.x - centre.x); });
  return points;
}

/// The part of a convex polygon where dot(side, (p, 1)) >= 0.
std::vector<glm::dvec2> cut(const std::vector<glm::dvec2>& polygon, const glm::dvec3& side) {
  std::vector<glm::dvec2> part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = glm::dot(side, glm::dvec3(a, 1)), at_b = glm::dot(side, glm::dvec3(b, 1));
    if (at_a >= 0) part.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) part.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return part;
}

bool meets(std::vector<glm::dvec2> polygon, const glm::dvec2& half_size) {
  for (const glm::dvec3& side : {glm::dvec3(1, 0, half_size.x), glm::dvec3(-1, 0, half_size.x),
                                 glm::dvec3(0, 1, half_size.y), glm::dvec3(0, -1, half_size.y)})
    polygon = cut(polygon, side);
  return !polygon.empty();
}

}  // namespace

void split_bodies_exactly(Scene& scene) {
  if (scene.portals.empty()) return;
  const std::vector<glm::dmat4> world = world_matrices_exact(scene.nodes);
  const int count = int(world.size());
  for (int body = 0; body < count; ++body) {
    if (!scene.nodes[std::size_t(body)].travels) continue;
    const std::vector<int> parts = parts_of(scene, body);
    const auto standing = std::ranges::find_if(scene.portals, [&](const Portal& portal) {
      if (!portal.exit) return false;
      const Material& material = scene.materials[std::size_t(scene.nodes[std::size_t(portal.node)].material)];
      const glm::dvec4 origin = world[std::size_t(body)][3];
      if (!material.two_sided && glm::dot(plane_of(world[std::size_t(portal.node)], false), origin) < 0) return false;
      const glm::dvec2 half_size = half_size_of(scene, portal);
      const glm::dmat4 to_frame = glm::inverse(world[std::size_t(portal.node)]);
      return std::ranges::any_of(parts, [&](int part) {
        const Mesh& mesh = scene.meshes[std::size_t(*scene.nodes[std::size_t(part)].mesh)];
        return meets(section(box_around(mesh), to_frame * world[std::size_t(part)]), half_size);
      });
    });
    if (standing == scene.portals.end()) continue;
    const glm::dmat4 &entry = world[std::size_t(standing->node)], &exit = world[std::size_t(*standing->exit)];
    const bool turned = glm::dot(plane_of(entry, false), world[std::size_t(body)][3]) < 0;  // only if it is two-sided
    const glm::dmat4 through = oracle::passage_of(*standing, world);
    for (const int part : parts) {
      add_part(scene, scene.nodes[std::size_t(part)], through * world[std::size_t(part)], plane_of(exit, turned));
      scene.nodes[std::size_t(part)].kept = plane_of(entry, turned);
    }
  }
}

}  // namespace atelier
