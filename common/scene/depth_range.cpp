#include "scene/depth_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace atelier {
namespace {

/// Float error of a point's position, relative to the largest coordinate in its computation: 6 units in the last place,
/// 2^-23 each.
constexpr double doubt = 6 * 1.2e-7;

/// The camera's position and its axes, which are unit vectors.
struct Frame {
  glm::dvec3 eye, right, up, forward;
};

Frame frame_of(const Camera& camera) {
  const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
  glm::dvec3 right = glm::cross(forward, glm::dvec3(camera.up));
  if (glm::length(right) <= 1e-6 * glm::length(glm::dvec3(camera.up))) {
    // Up is parallel to the view, or zero: use the axis that is closest to perpendicular to the view, the first of
    // equals.
    const glm::dvec3 size = glm::abs(forward);
    const int axis = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
    glm::dvec3 other(0);
    other[axis] = 1;
    right = glm::cross(forward, other);
  }
  right = glm::normalize(right);
  return {camera.eye, right, glm::cross(right, forward), forward};
}

/// A half-space: dot(normal, p) >= offset is inside.
struct Plane {
  glm::dvec3 normal;
  double offset;
};

/// The four side planes of the view volume, and the plane through the eye that excludes points behind a perspective
/// camera.
std::vector<Plane> sides_of(const Camera& camera, const Frame& frame, double aspect) {
  const bool perspective = camera.projection == Projection::perspective;
  const double half_height = perspective ? std::tan(double(camera.fov_y) / 2) : double(camera.height) / 2;
  std::vector<Plane> planes;
  for (const auto& [axis, half] : {std::pair(frame.right, half_height * aspect), std::pair(frame.up, half_height)})
    for (const double sign : {-1.0, 1.0}) {
      const glm::dvec3 normal = sign * axis + (perspective ? half * frame.forward : glm::dvec3(0));
      planes.push_back({normal, glm::dot(normal, frame.eye) - (perspective ? 0 : half)});
    }
  if (perspective) planes.push_back({frame.forward, glm::dot(frame.forward, frame.eye)});
  return planes;
}

/// Clips a planar convex polygon to the inner side of a plane (Sutherland and Hodgman, 1974).
std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& polygon, const Plane& plane) {
  std::vector<glm::dvec3> left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = glm::dot(plane.normal, a) - plane.offset, at_b = glm::dot(plane.normal, b) - plane.offset;
    if (at_a >= 0) left.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) left.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return left;
}

/// Side 0..5 of a box: the low or the high end of each axis.
std::vector<glm::dvec3> side_of(const Box3& box, int side) {
  const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<glm::dvec3> corners(4, side % 2 ? box.high : box.low);
  for (int i = 0; i < 4; ++i) {
    corners[std::size_t(i)][u] = i == 1 || i == 2 ? box.high[u] : box.low[u];
    corners[std::size_t(i)][v] = i >= 2 ? box.high[v] : box.low[v];
  }
  return corners;
}

bool contains(const Box3& box, const glm::dvec3& p) {
  return glm::all(glm::lessThanEqual(box.low, p)) && glm::all(glm::lessThanEqual(p, box.high));
}

double largest_coordinate(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 largest = glm::max(glm::abs(a), glm::abs(b));
  return std::max({largest.x, largest.y, largest.z});
}

}  // namespace

std::vector<Box3> node_boxes(const Scene& scene) {
  const std::vector<glm::dmat4> world = world_matrices_exact(scene.nodes);
  std::vector<Box3> boxes(scene.nodes.size());
  double coordinate = 0;  // the largest translation of all nodes, including those without a mesh
  for (const glm::dmat4& matrix : world) {
    const glm::dvec3 place(matrix[3]);
    coordinate = std::max(coordinate, largest_coordinate(place, place));
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!scene.nodes[i].mesh) continue;
    Box3& box = boxes[i];
    box = box_around(scene.meshes.at(std::size_t(*scene.nodes[i].mesh)), world[i]);
    if (box.empty()) continue;
    const glm::dvec3 slack(doubt * std::max(coordinate, largest_coordinate(box.low, box.high)));
    box.low -= slack;
    box.high += slack;
  }
  return boxes;
}

std::optional<DepthRange> visible_depths(const Camera& camera, double aspect, const Box3& box) {
  if (box.empty()) return {};
  const Frame frame = frame_of(camera);
  const std::vector<Plane> planes = sides_of(camera, frame, aspect);
  std::optional<DepthRange> range;
  const auto add = [&](const glm::dvec3& point) {
    const double depth = glm::dot(frame.forward, point - frame.eye);
    if (!range) range = {depth, depth};
    range->near = std::min(range->near, depth);
    range->far = std::max(range->far, depth);
  };
  // Every corner of the visible part lies on a side of the box, except the apex of the view volume.
  for (int side = 0; side < 6; ++side) {
    std::vector<glm::dvec3> polygon = side_of(box, side);
    for (const Plane& plane : planes) polygon = clipped(polygon, plane);
    for (const glm::dvec3& corner : polygon) add(corner);
  }
  if (camera.projection == Projection::perspective && contains(box, camera.eye)) add(camera.eye);
  return range;
}

Camera fit_depth(Camera camera, double aspect, std::span<const Box3> boxes) {
  std::optional<DepthRange> all;
  double coordinate = largest_coordinate(camera.eye, camera.target);
  for (const Box3& box : boxes) {
    const auto range = visible_depths(camera, aspect, box);
    if (!range) continue;
    coordinate = std::max(coordinate, largest_coordinate(box.low, box.high));
    all = all ? DepthRange{std::min(all->near, range->near), std::max(all->far, range->far)} : *range;
  }
  if (!all) return camera;
  const auto slack = [&](double depth) { return doubt * coordinate + 1e-5 * std::abs(depth); };
  const float near = std::max(camera.near, float(all->near - slack(all->near)));
  const float far = std::min(camera.far, float(all->far + slack(all->far)));
  if (!(near < far)) return camera;  // everything visible is outside its near and far planes
  camera.near = near;
  camera.far = far;
  return camera;
}

}  // namespace atelier
