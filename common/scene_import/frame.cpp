#include "scene_import/frame.hpp"

#include <algorithm>
#include <cmath>

namespace atelier::scene_import {
namespace {

Ball ball_around(const Box3& box) {
  if (box.empty()) return {{0, 0, 0}, 1};
  const double radius = glm::length(box.high - box.low) / 2;
  return {(box.low + box.high) / 2.0, radius > 0 ? radius : 1};
}

}  // namespace

Camera camera_around(const Box3& box) {
  const Ball ball = ball_around(box);
  Camera camera;
  constexpr double margin = 1.03;
  const double distance = margin * ball.radius / std::sin(camera.fov_y / 2);
  camera.target = ball.centre;
  camera.eye = ball.centre + distance * glm::normalize(glm::dvec3(0.5, 0.35, 1));
  camera.near = float(0.5 * (distance - ball.radius));
  camera.far = float(1.5 * (distance + ball.radius));
  return camera;
}

void fit_depth(Camera& camera, const Box3& box) {
  const Ball ball = ball_around(box);
  const glm::dvec3 ahead = glm::normalize(camera.target - camera.eye);
  const double depth = glm::dot(ball.centre - camera.eye, ahead);
  camera.target = camera.eye + ahead * std::max(depth, 0.01 * ball.radius);
  if (!(camera.far > camera.near)) camera.far = float(std::max(1.1 * (depth + ball.radius), 1000.0 * camera.near));
}

Light key_light(const Camera& camera) {
  const glm::dvec3 ahead = glm::normalize(camera.target - camera.eye);
  const glm::dvec3 across = glm::cross(ahead, glm::dvec3(camera.up));
  const glm::dvec3 right = glm::length(across) > 1e-6 ? glm::normalize(across) : glm::dvec3(1, 0, 0);
  const glm::dvec3 up = glm::cross(right, ahead);
  return {.type = LightType::directional,
          .name = "key",
          .direction = glm::vec3(glm::normalize(ahead + 0.5 * right - 0.7 * up))};
}

}  // namespace atelier::scene_import
