#include "03-shadow-mapping/given/map_truth.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "oracle/frame.hpp"
#include "scene/builder.hpp"

namespace atelier {

namespace {

using Corners = std::vector<glm::dvec3>;  ///< of boxes, eight a box, world space

/// The corners of the boxes of all nodes that `takes_part` selects; each box is aligned with its object's axes.
template <class Predicate>
Corners corners_of_nodes(const Scene& scene, Predicate takes_part) {
  const std::vector<glm::dmat4> models = world_matrices_exact(scene.nodes);
  Corners corners;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (!node.mesh || !takes_part(node)) continue;
    const Box3 box = box_around(scene.meshes[std::size_t(*node.mesh)]);
    if (box.empty()) continue;
    for (const glm::dvec3& corner : corners_of(box, models[i])) corners.push_back(corner);
  }
  return corners;
}

double depth_along(const ExactFrustum& frustum, const glm::dvec3& point) {
  return glm::dot(point - frustum.eye, frustum.direction);
}

ExactFrustum around_directional(const Light& light, const Ball& ball) {
  const glm::dvec3 direction = glm::normalize(glm::dvec3(light.direction));
  const double radius = std::max(ball.radius, 1e-6);
  return {.orthographic = true,
          .eye = ball.centre - radius * direction,
          .direction = direction,
          .extent = radius,
          .near = 0,
          .far = 2 * radius};
}

/// `casters`: their boxes' corners, at least eight.
ExactFrustum around_spot(const Light& light, const Ball& ball, const Corners& casters) {
  ExactFrustum frustum{.eye = light.position,
                       .direction = glm::normalize(glm::dvec3(light.direction)),
                       .extent = double(light.outer_angle)};
  const glm::dvec3 to_centre = ball.centre - light.position;
  const double distance = glm::length(to_centre);
  if (distance > ball.radius && std::asin(ball.radius / distance) <= frustum.extent) {
    frustum.direction = to_centre / distance;
    frustum.extent = std::asin(ball.radius / distance);
  }
  frustum.extent = std::clamp(frustum.extent, 0.001, 1.5);
  const double middle = glm::dot(to_centre, frustum.direction);
  frustum.far = std::max(middle + ball.radius, 1e-6);
  const double least = std::max(middle - ball.radius, frustum.far / 1000);
  double nearest = frustum.far;
  for (const glm::dvec3& corner : casters) nearest = std::min(nearest, depth_along(frustum, corner));
  frustum.near = std::min(std::max(0.99 * nearest, least), 0.99 * frustum.far);
  return frustum;
}

/// Coordinates along a light's right, up and ahead, metres, and the half-width of its frustum there.
struct InLightSpace {
  glm::dvec3 place;
  double half_width;
};

InLightSpace in_light_space(const ExactFrustum& frustum, const glm::dvec3& position) {
  const oracle::ViewFrame frame = oracle::view_frame(frustum.direction, {0, 1, 0});
  const glm::dvec3 p = position - frustum.eye;
  const glm::dvec3 place(glm::dot(p, frame.right), glm::dot(p, frame.up), glm::dot(p, frame.ahead));
  return {place, frustum.orthographic ? frustum.extent : place.z * std::tan(frustum.extent)};
}

/// Whether a spot's cone does not intersect a sphere.
bool shines_past(const Light& spot, const Ball& ball) {
  const glm::dvec3 way = ball.centre - spot.position;
  const double distance = glm::length(way);
  if (distance <= ball.radius) return false;
  const double off =
      std::acos(glm::clamp(glm::dot(way, glm::normalize(glm::dvec3(spot.direction))) / distance, -1.0, 1.0));
  return off > spot.outer_angle + std::asin(ball.radius / distance);
}

/// Whether any box may intersect the light's frustum, extended up to the light: the near plane is ignored.
bool reaches_any(const ExactFrustum& frustum, const Corners& boxes) {
  for (std::size_t i = 0; i < boxes.size(); i += 8) {
    // How many of the box's corners lie on the far side of each of five planes: left, right, below, above, far.
    int outside[5] = {};
    for (std::size_t k = i; k < i + 8; ++k) {
      const auto [p, half] = in_light_space(frustum, boxes[k]);
      const bool beyond[5] = {p.x<-half, p.x> half, p.y<-half, p.y> half, p.z > frustum.far};
      for (int plane = 0; plane < 5; ++plane) outside[plane] += beyond[plane];
    }
    if (std::ranges::none_of(outside, [](int corners) { return corners == 8; })) return true;
  }
  return false;
}

}  // namespace

std::vector<glm::dvec3> caster_corners_exact(const Scene& scene) {
  return corners_of_nodes(scene, [](const Node& node) { return node.casts_shadow; });
}

std::optional<ExactFrustum> exact_frustum(const Scene& scene, const Light& light, MapFit fit) {
  if (!light.casts_shadow || light.type == LightType::point) return {};
  const Corners casters = caster_corners_exact(scene);
  if (casters.empty()) return {};
  if (light.type == LightType::spot && shines_past(light, ball_around(casters))) return {};
  const Corners all = fit == MapFit::casters ? casters : corners_of_nodes(scene, [](const Node& node) {
    return node.casts_shadow || node.receives_shadow;
  });
  const Ball ball = ball_around(all);
  const ExactFrustum frustum =
      light.type == LightType::directional ? around_directional(light, ball) : around_spot(light, ball, casters);
  if (!reaches_any(frustum, casters)) return {};
  return frustum;
}

glm::dvec3 exact_shadow_coordinate(const ExactFrustum& frustum, const glm::dvec3& position) {
  const auto [p, half] = in_light_space(frustum, position);
  if (!frustum.orthographic && p.z <= 0) return {0, 0, 2};
  const double n = frustum.near, f = frustum.far;
  const double depth = frustum.orthographic ? (p.z - n) / (f - n) : f * (p.z - n) / (p.z * (f - n));
  return {(p.x / half + 1) / 2, (p.y / half + 1) / 2, std::min(depth, 1.0)};
}

Camera camera_of(const ExactFrustum& frustum) {
  Camera camera{.eye = frustum.eye, .target = frustum.eye + frustum.direction};
  if (frustum.orthographic) {
    camera.projection = Projection::orthographic;
    camera.height = float(2 * frustum.extent);
    camera.near = float(-1000 * frustum.far);
    camera.far = float(1000 * frustum.far);
  } else {
    camera.fov_y = float(2 * frustum.extent);
    camera.near = float(1e-6 * frustum.far);
    camera.far = float(1000 * frustum.far);
  }
  return camera;
}

Scene casters_alone(Scene scene, bool back_faces_only) {
  for (Node& node : scene.nodes)
    if (!node.casts_shadow) node.mesh.reset();
  for (Material& material : scene.materials) material.two_sided = !back_faces_only;
  if (back_faces_only)  // flipping the winding makes back faces front faces
    for (Mesh& mesh : scene.meshes)
      for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i], mesh.indices[i + 1]);
  set_background(scene, glm::vec3(1));
  return scene;
}

}  // namespace atelier
