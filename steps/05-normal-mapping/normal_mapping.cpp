#include "05-normal-mapping/normal_mapping.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace atelier::normal_mapping {

glm::vec4 triangle_tangent(const Corner& a, const Corner& b, const Corner& c) {
  // TODO(05-normal-mapping): solve the two edges for the direction of +u
  return glm::vec4(0);
}

std::vector<glm::vec4> vertex_tangents(const Mesh& mesh) {
  // TODO(05-normal-mapping): sum the tangents of each vertex's triangles by their angles
  return std::vector<glm::vec4>(mesh.vertices.size(), glm::vec4(0));
}

Image normals_from_heights(const Image& heights, float depth, Wrap wrap) {
  // TODO(05-normal-mapping): the slopes along u and v, then the normal, then its colour
  return Image(heights.width(), heights.height(), {0.5f, 0.5f, 1, 1});
}

}  // namespace atelier::normal_mapping
