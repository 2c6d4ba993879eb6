#include "scene/box.hpp"

#include <algorithm>

#include "scene/scene.hpp"

namespace atelier {

Box3 box_around(std::span<const glm::dvec3> points) {
  Box3 box;
  for (const glm::dvec3& point : points) box.add(point);
  return box;
}

Box3 box_around(const Mesh& mesh) {
  Box3 box;
  for (const Vertex& vertex : mesh.vertices) box.add(glm::dvec3(vertex.position));
  return box;
}

Box3 box_around(const Mesh& mesh, const glm::dmat4& matrix) {
  Box3 box;
  for (const Vertex& vertex : mesh.vertices) box.add(glm::dvec3(matrix * glm::dvec4(glm::dvec3(vertex.position), 1)));
  return box;
}

std::array<glm::dvec3, 8> corners_of(const Box3& box) {
  std::array<glm::dvec3, 8> corners;
  for (unsigned i = 0; i < corners.size(); ++i)
    corners[i] = {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y, i & 4 ? box.high.z : box.low.z};
  return corners;
}

std::array<glm::dvec3, 8> corners_of(const Box3& box, const glm::dmat4& matrix) {
  std::array<glm::dvec3, 8> corners = corners_of(box);
  for (glm::dvec3& corner : corners) corner = glm::dvec3(matrix * glm::dvec4(corner, 1));
  return corners;
}

Ball ball_around(std::span<const glm::dvec3> points) {
  const Box3 box = box_around(points);
  Ball ball{.centre = (box.low + box.high) * 0.5};
  for (const glm::dvec3& point : points) ball.radius = std::max(ball.radius, glm::distance(point, ball.centre));
  return ball;
}

}  // namespace atelier
