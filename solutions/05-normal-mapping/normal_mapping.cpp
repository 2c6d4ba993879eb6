#include "05-normal-mapping/normal_mapping.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace atelier::normal_mapping {

glm::vec4 triangle_tangent(const Corner& a, const Corner& b, const Corner& c) {
  // >>> student: solve the two edges for the direction of +u
  const glm::vec3 e1 = b.position - a.position, e2 = c.position - a.position;
  const glm::vec2 d1 = b.texcoord - a.texcoord, d2 = c.texcoord - a.texcoord;
  const auto squared = [](const auto& v) { return glm::dot(v, v); };
  const float edge = std::sqrt(std::max({squared(e1), squared(e2), squared(e2 - e1)}));
  const float side = std::sqrt(std::max({squared(d1), squared(d2), squared(d2 - d1)}));
  if (edge == 0 || side == 0) return glm::vec4(0);
  // In units of the longest edges, so that no product leaves the range of a float.
  const glm::vec3 p1 = e1 / edge, p2 = e2 / edge;
  const glm::vec2 q1 = d1 / side, q2 = d2 / side;
  const float determinant = q1.x * q2.y - q1.y * q2.x;
  if (glm::length(glm::cross(p1, p2)) <= 1e-6f || std::abs(determinant) <= 1e-6f) return glm::vec4(0);
  const float way = determinant < 0 ? -1.0f : 1.0f;
  return glm::vec4(glm::normalize(way * (q2.y * p1 - q1.y * p2)), way);
  // --- skeleton
  // | return glm::vec4(0);
  // <<< student
}

std::vector<glm::vec4> vertex_tangents(const Mesh& mesh) {
  // >>> student: sum the tangents of each vertex's triangles by their angles
  struct Sum {
    glm::vec3 direction{0};
    float weight = 0, way = 0;
  };
  std::vector<Sum> sums(mesh.vertices.size());
  for (std::size_t at = 0; at + 2 < mesh.indices.size(); at += 3) {
    const auto vertex = [&](std::size_t k) -> const Vertex& { return mesh.vertices[mesh.indices[at + k % 3]]; };
    const auto corner = [&](std::size_t k) { return Corner{vertex(k).position, vertex(k).texcoord}; };
    const glm::vec4 tangent = triangle_tangent(corner(0), corner(1), corner(2));
    if (tangent == glm::vec4(0)) continue;
    const float scale = 1 / glm::length(vertex(1).position - vertex(0).position);
    const auto edge = [&](std::size_t i, std::size_t k) { return (vertex(k).position - vertex(i).position) * scale; };
    const float double_area = glm::length(glm::cross(edge(0, 1), edge(0, 2)));  // the same from every corner
    const auto side = [&](std::size_t k) { return glm::dot(edge(k, k + 1), edge(k, k + 2)); };
    const std::array sides = {side(0), side(1), side(2)};
    // Two arc tangents: the widest angle is what the others leave of half a turn.
    const auto widest = std::size_t(std::min_element(sides.begin(), sides.end()) - sides.begin());
    const std::size_t next = (widest + 1) % 3, last = (widest + 2) % 3;
    std::array<float, 3> angles{};
    for (const std::size_t k : {next, last}) angles[k] = std::atan2(double_area, sides[k]);
    angles[widest] = 3.14159265f - (angles[next] + angles[last]);
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3 n = vertex(k).normal, t = glm::vec3(tangent);
      const glm::vec3 flat = t - glm::dot(t, n) * n;
      const float size = glm::length(flat);
      Sum& sum = sums[mesh.indices[at + k]];
      if (size > 1e-6f) sum.direction += angles[k] / size * flat;
      sum.weight += angles[k];
      sum.way += angles[k] * tangent.w;
    }
  }
  std::vector<glm::vec4> tangents(mesh.vertices.size(), glm::vec4(0));
  for (std::size_t v = 0; v < tangents.size(); ++v) {
    const glm::vec3 n = mesh.vertices[v].normal;
    const Sum& sum = sums[v];
    if (n == glm::vec3(0) || !(glm::length(sum.direction) > 1e-4f * sum.weight)) continue;
    const glm::vec3 t = sum.direction - glm::dot(sum.direction, n) * n;
    tangents[v] = glm::vec4(glm::normalize(t), sum.way < 0 ? -1.0f : 1.0f);
  }
  return tangents;
  // --- skeleton
  // | return std::vector<glm::vec4>(mesh.vertices.size(), glm::vec4(0));
  // <<< student
}

Image normals_from_heights(const Image& heights, float depth, Wrap wrap) {
  // >>> student: the slopes along u and v, then the normal, then its colour
  const int width = heights.width(), height = heights.height();
  const auto beyond = [&](int i, int count) {
    return wrap == Wrap::repeat ? (i + count) % count : std::clamp(i, 0, count - 1);
  };
  const auto h = [&](int x, int y) { return depth * heights.at(beyond(x, width), beyond(y, height)).r; };
  Image normals(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float slope_u = (h(x + 1, y) - h(x - 1, y)) * 0.5f * float(width);
      const float slope_v = (h(x, y - 1) - h(x, y + 1)) * 0.5f * float(height);
      const glm::vec3 n = glm::normalize(glm::vec3(-slope_u, -slope_v, 1)) * 0.5f + 0.5f;
      normals.at(x, y) = {n.x, n.y, n.z, 1};
    }
  return normals;
  // --- skeleton
  // | return Image(heights.width(), heights.height(), {0.5f, 0.5f, 1, 1});
  // <<< student
}

}  // namespace atelier::normal_mapping
