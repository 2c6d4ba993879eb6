#include "03-shadow-mapping/given/shadow_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace atelier {

namespace {

/// The signed distance of a point in clip space from the i-th of the six planes -w <= x, x <= w, ...; negative outside.
double within(const glm::dvec4& clip, int i) {
  return i % 2 == 0 ? clip.w + clip[i / 2] : clip.w - clip[i / 2];
}

/// Clips a convex polygon in clip space to a plane (Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974).
std::vector<glm::dvec4> cut(const std::vector<glm::dvec4>& polygon, int plane) {
  std::vector<glm::dvec4> left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec4 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = within(a, plane), at_b = within(b, plane);
    if (at_a >= 0) left.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) left.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return left;
}

glm::dvec3 without_w(const glm::dvec4& p) {
  return glm::dvec3(p) / p.w;
}

/// Clips polygons to the view volume, through clip space.
struct Cutter {
  glm::dmat4 to_clip, to_world;

  explicit Cutter(const Viewpoint& viewpoint)
      : to_clip(glm::dmat4(viewpoint.projection) * glm::dmat4(viewpoint.world_to_view)),
        to_world(glm::inverse(to_clip)) {}

  /// The corners of a clipped convex polygon.
  std::vector<glm::dvec3> cut_to_view(std::span<const glm::dvec3> polygon) const {
    std::vector<glm::dvec4> left;
    for (const glm::dvec3& point : polygon) left.push_back(to_clip * glm::dvec4(point, 1));
    for (int plane = 0; plane < 6; ++plane) left = cut(left, plane);
    std::vector<glm::dvec3> points;
    for (const glm::dvec4& p : left) points.push_back(without_w(to_world * p));
    return points;
  }
};

/// Columns: two directions perpendicular to a unit vector and to each other, and the vector. The first two are along
/// the map's edges, as in the light's look_at, so that a rectangle measured along them fits the map.
glm::dmat3 frame_around(const glm::dvec3& z) {
  const glm::dvec3 up(0, 1, 0);
  const glm::dvec3 other = glm::length(glm::cross(up, z)) > 1e-6 ? up : glm::dvec3(1, 0, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(other, z));
  return {x, glm::cross(z, x), z};
}

}  // namespace

bool casts(const Scene& scene, const ScenePainter::Item& item) {
  return scene.nodes[std::size_t(item.node)].casts_shadow;
}
bool receives(const Scene& scene, const ScenePainter::Item& item) {
  return scene.nodes[std::size_t(item.node)].receives_shadow;
}

std::array<glm::dvec3, 8> corners_of(const ScenePainter::Item& item) {
  return corners_of(item.box, glm::dmat4(item.model));
}

std::vector<glm::dvec3> visible_corners(const ScenePainter::Item& item, const Viewpoint& viewpoint) {
  const Cutter cutter(viewpoint);
  const std::array<glm::dvec3, 8> corners = corners_of(item);
  // Six faces by their corners' numbers, in order around the face.
  static constexpr int faces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                      {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  std::vector<glm::dvec3> seen;
  for (const auto& face : faces) {
    std::vector<glm::dvec3> polygon;
    for (const int i : face) polygon.push_back(corners[std::size_t(i)]);
    for (const glm::dvec3& point : cutter.cut_to_view(polygon)) seen.push_back(point);
  }
  // The view volume's own corners that are inside the box.
  const glm::dmat4 world_to_object = glm::inverse(glm::dmat4(item.model));
  for (const glm::dvec3& corner : corners_of(Box3{glm::dvec3(-1), glm::dvec3(1)})) {
    const glm::dvec3 p = without_w(cutter.to_world * glm::dvec4(corner, 1));
    const glm::dvec3 inside = glm::dvec3(world_to_object * glm::dvec4(p, 1));
    if (glm::all(glm::greaterThanEqual(inside, item.box.low)) && glm::all(glm::lessThanEqual(inside, item.box.high)))
      seen.push_back(p);
  }
  return seen;
}

Pieces visible_receivers(const Scene& scene, std::span<const ScenePainter::Item> items, const Viewpoint& viewpoint) {
  constexpr std::size_t plain = 64 * 3;  // indices: clipping more triangles would cost more than it saves
  const Cutter cutter(viewpoint);
  Pieces pieces;
  for (const ScenePainter::Item& item : items) {
    const Node& node = scene.nodes[std::size_t(item.node)];
    if (!node.receives_shadow || item.box.empty()) continue;
    const Mesh& mesh = scene.meshes[std::size_t(*node.mesh)];
    if (mesh.indices.size() > plain) {
      pieces.push_back(visible_corners(item, viewpoint));
      continue;
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      std::array<glm::dvec3, 3> triangle;
      for (std::size_t k = 0; k < 3; ++k)
        triangle[k] = glm::dmat4(item.model) * glm::dvec4(mesh.vertices[mesh.indices[i + k]].position, 1);
      pieces.push_back(cutter.cut_to_view(triangle));
    }
  }
  std::erase_if(pieces, [](const std::vector<glm::dvec3>& piece) { return piece.empty(); });
  return pieces;
}

glm::ivec4 texels_of(const Pieces& pieces, const glm::mat4& world_to_map, int resolution, float aside) {
  const glm::ivec4 all(0, 0, resolution, resolution);
  glm::dvec2 low(resolution), high(0);
  for (const auto& piece : pieces)
    for (const glm::dvec3& point : piece) {
      const glm::dvec4 mapped = glm::dmat4(world_to_map) * glm::dvec4(point, 1);
      if (mapped.w <= 0) return all;  // behind the light's plane: its projection may be anywhere
      const glm::dvec2 texel = glm::dvec2(mapped) / mapped.w * double(resolution);
      low = glm::min(low, texel), high = glm::max(high, texel);
    }
  const glm::ivec2 from(glm::clamp(glm::floor(low - double(aside)), 0.0, double(resolution))),
      to(glm::clamp(glm::ceil(high + double(aside)), 0.0, double(resolution)));
  return {from, glm::max(to - from, glm::ivec2(0))};
}

bool looks_into(const Pieces& pieces, const glm::mat4& view, float aside) {
  const glm::dmat4 to_view(view);
  const double widest = 1 + double(aside);
  const auto outside = [&](const std::vector<glm::dvec3>& piece, int axis, double sign) {
    return std::all_of(piece.begin(), piece.end(), [&](const glm::dvec3& point) {
      const glm::dvec4 p = to_view * glm::dvec4(point, 1);
      return sign * p[axis] > -p.z * widest;
    });
  };
  return std::any_of(pieces.begin(), pieces.end(), [&](const std::vector<glm::dvec3>& piece) {
    return !outside(piece, 0, 1) && !outside(piece, 0, -1) && !outside(piece, 1, 1) && !outside(piece, 1, -1);
  });
}

std::optional<shadow_mapping::Sphere> sphere_around(std::span<const glm::dvec3> points) {
  if (points.empty()) return {};
  const Ball ball = ball_around(points);
  return shadow_mapping::Sphere{glm::vec3(ball.centre), float(ball.radius)};
}

float radians_across(const shadow_mapping::Sphere& sphere, const glm::vec3& from) {
  const float distance = glm::distance(sphere.centre, from);
  return distance > sphere.radius ? std::asin(sphere.radius / distance) : 4.0f;
}

bool shines_past(const Light& spot, const glm::vec3& position, const shadow_mapping::Sphere& sphere) {
  const glm::vec3 way = sphere.centre - position, axis = glm::normalize(spot.direction);
  const float off = std::atan2(glm::length(glm::cross(axis, way)), glm::dot(axis, way));
  return off > spot.outer_angle + radians_across(sphere, position);
}

float nearest_depth(std::span<const glm::dvec3> points, const shadow_mapping::LightFrustum& frustum) {
  double nearest = frustum.far;
  for (const glm::dvec3& point : points)
    nearest = std::min(nearest, glm::dot(point - glm::dvec3(frustum.eye), glm::dvec3(frustum.direction)));
  return float(nearest);
}

std::optional<shadow_mapping::LightFrustum> fit_directional_to_both(const glm::vec3& direction,
                                                                    std::span<const glm::dvec3> casters,
                                                                    std::span<const glm::dvec3> receivers) {
  if (casters.empty() || receivers.empty()) return {};
  const glm::dmat3 from_light = frame_around(glm::normalize(glm::dvec3(direction)));
  const auto box_seen = [&](std::span<const glm::dvec3> points) {
    Box3 box;
    for (const glm::dvec3& point : points) box.add(point * from_light);  // the transpose: world to light
    return box;
  };
  const Box3 above = box_seen(casters), below = box_seen(receivers);
  Box3 both{glm::max(above.low, below.low), glm::min(above.high, below.high)};
  both.low.z = above.low.z, both.high.z = below.high.z;
  if (both.low.x > both.high.x || both.low.y > both.high.y || both.low.z > both.high.z) return {};
  const glm::dvec3 size = both.high - both.low, middle = from_light * ((both.low + both.high) * 0.5);
  shadow_mapping::LightFrustum frustum =
      shadow_mapping::fit_directional(direction, {glm::vec3(middle), float(std::max(size.x, size.y) / 2)});
  const float eye = glm::dot(frustum.eye, frustum.direction);
  const float slack = 1e-4f * float(size.z) + 1e-6f;  // float error must not put the farthest receiver behind the plane
  frustum.eye += (float(both.low.z) - eye - slack) * frustum.direction;  // depths begin here: none is negative
  frustum.near = 0;
  frustum.far = float(size.z) + 2 * slack;
  return frustum;
}

}  // namespace atelier
