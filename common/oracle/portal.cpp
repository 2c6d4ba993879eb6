#include "oracle/portal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
    by_node_[std::size_t(portal.node)] = {portal.colour, passage_of(portal, world), portal.exit.value_or(portal.node)};
}

const Portals::Opening* Portals::at(const SurfacePoint& point) const {
  if (std::size_t(point.thing) >= by_node_.size()) return nullptr;
  const std::optional<Opening>& opening = by_node_[std::size_t(point.thing)];
  return opening ? &*opening : nullptr;
}

namespace {

/// The interval after a point.
Ray after(Ray ray, const SurfacePoint& point) {
  ray.least = std::nextafter(point.t, std::numeric_limits<double>::infinity());
  return ray;
}

/// The first point in the interval of `ray`, a part of the segment's, except on the opening that it has come out of.
std::optional<SurfacePoint> seen_except_exit(const World& world, const Portals& portals, const Segment& segment,
                                             Ray ray) {
  std::optional<SurfacePoint> point = world.seen(ray);
  while (point && segment.exit == point->thing && portals.at(*point)) {
    ray = after(ray, *point);
    point = world.seen(ray);
  }
  return point;
}

}  // namespace

std::optional<SurfacePoint> first_opening(const World& world, const Portals& portals, const Segment& segment,
                                          double end) {
  if (world.scene().portals.empty() || segment.start >= end) return {};
  Ray ray{.origin = segment.ray.origin, .direction = segment.ray.direction, .least = segment.start, .most = end};
  std::optional<SurfacePoint> point = seen_except_exit(world, portals, segment, ray);
  while (point && !portals.at(*point)) {
    ray = after(ray, *point);
    point = seen_except_exit(world, portals, segment, ray);
  }
  if (point && point->t >= end) return {};
  return point;
}

std::optional<SurfacePoint> first_seen(const World& world, const Portals& portals, const Segment& segment) {
  const std::optional<SurfacePoint> opening = first_opening(world, portals, segment, segment.ray.least);
  return opening ? opening : seen_except_exit(world, portals, segment, segment.ray);
}

Segment beyond(const Portals::Opening& opening, const Segment& segment, double t) {
  const Ray& ray = segment.ray;
  return {.ray = {.origin = glm::dvec3(opening.through * glm::dvec4(ray.origin, 1)),
                  .direction = glm::dvec3(opening.through * glm::dvec4(ray.direction, 0)),
                  .least = std::max(t, ray.least),
                  .most = ray.most},
          .start = t,
          .exit = opening.exit};
}

}  // namespace atelier::oracle
