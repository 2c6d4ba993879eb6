#include "03-shadow-mapping/given/light_image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "render/bind_viewpoint.hpp"

namespace atelier {

namespace {

/// Through the origin of a frame, positive where its +z points.
glm::dvec4 plane_of(const glm::dmat4& frame) {
  const glm::dvec3 normal(frame[2]);
  return {normal, -glm::dot(normal, glm::dvec3(frame[3]))};
}

}  // namespace

MovedPassage moved_passage(const Passage& passage, const glm::dvec3& origin) {
  const glm::dmat4 there = glm::translate(glm::dmat4(1), -origin), back = glm::translate(glm::dmat4(1), origin);
  return {glm::mat4(there * passage.through * back), moved_plane(plane_of(passage.entry_to_world), origin),
          moved_plane(plane_of(passage.exit_to_world), origin)};
}

shadow_mapping::LightFrustum frustum_through(const Light& image, const glm::dvec3& origin,
                                             std::span<const glm::dvec3> points) {
  const Passage& passage = *image.passage;
  const glm::dvec3 centre = glm::dvec3(passage.exit_to_world[3]) - origin;
  const bool parallel = image.type == LightType::directional;
  const glm::dvec3 eye = parallel ? centre : image.position - origin;
  const glm::dvec3 axis = glm::normalize(parallel ? glm::dvec3(image.direction) : centre - eye);
  double extent = 0, near = 1e300, far = 0;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      const glm::dvec4 corner =
          passage.exit_to_world * glm::dvec4(x * passage.half_size.x, y * passage.half_size.y, 0, 1);
      const glm::dvec3 way = glm::dvec3(corner) - origin - eye;
      const double along = glm::dot(axis, way), aside = glm::length(way - along * axis);
      extent = std::max(extent, parallel ? aside : std::atan2(aside, along));
      near = std::min(near, along);
    }
  const glm::dvec3 ahead(passage.exit_to_world[2]);
  for (const glm::dvec3& point : points)
    if (glm::dot(ahead, point - centre) > 0) far = std::max(far, glm::dot(axis, point - eye));
  far = std::max(far, near + 1e-3);
  return {.orthographic = parallel,
          .eye = glm::vec3(eye),
          .direction = glm::vec3(axis),
          .extent = float(parallel ? extent : std::clamp(1.001 * extent, 0.001, 1.5)),
          .near = float(parallel ? near : std::max(0.99 * near, far / 1e5)),
          .far = float(far)};
}

}  // namespace atelier
