#include "12-gallery/given/wall_probe.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

namespace atelier {

namespace {

struct Met {
  double distance = 0;
  glm::dvec3 weights{0};  ///< of the three corners
};

/// Where a ray meets a triangle, from either side.
std::optional<Met> meet(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& from, const glm::dvec3& direction) {
  const glm::dvec3 a = corners[1] - corners[0], b = corners[2] - corners[0], p = glm::cross(direction, b);
  const double determinant = glm::dot(a, p);
  if (determinant == 0) return {};
  const glm::dvec3 offset = from - corners[0], q = glm::cross(offset, a);
  const double u = glm::dot(offset, p) / determinant, v = glm::dot(direction, q) / determinant,
               t = glm::dot(b, q) / determinant;
  if (u < 0 || v < 0 || u + v > 1 || t < 0) return {};
  return Met{t, {1 - u - v, u, v}};
}

}  // namespace

Numbers seen_from_axis(const Mesh& wall, const std::vector<double>& angles, const std::vector<double>& heights) {
  if (wall.indices.size() % 3 != 0) throw std::out_of_range("hall_wall: the indices are not three for each triangle");
  for (const std::uint32_t index : wall.indices)
    if (index >= wall.vertices.size()) throw std::out_of_range("hall_wall: an index is not that of a vertex");
  const auto vertex = [&](std::size_t at) { return wall.vertices[wall.indices[at]]; };
  const auto corners_at = [&](std::size_t at) {
    return std::array{glm::dvec3(vertex(at).position), glm::dvec3(vertex(at + 1).position),
                      glm::dvec3(vertex(at + 2).position)};
  };
  Numbers out;
  for (std::size_t i = 0; i < std::min(angles.size(), heights.size()); ++i) {
    const glm::dvec3 from(0, heights[i], 0), direction(-std::sin(angles[i]), 0, std::cos(angles[i]));
    int count = 0;
    Numbers first(7, 0);
    double nearest = INFINITY;
    for (std::size_t at = 0; at < wall.indices.size(); at += 3) {
      const std::array<glm::dvec3, 3> corners = corners_at(at);
      const std::optional<Met> met = meet(corners, from, direction);
      if (!met) continue;
      ++count;
      if (met->distance >= nearest) continue;
      nearest = met->distance;
      glm::dvec3 normal(0);
      glm::dvec2 texcoord(0);
      for (int k = 0; k < 3; ++k) {
        normal += met->weights[k] * glm::dvec3(vertex(at + std::size_t(k)).normal);
        texcoord += met->weights[k] * glm::dvec2(vertex(at + std::size_t(k)).texcoord);
      }
      const glm::dvec3 facing = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
      first = {nearest, double(glm::dot(facing, direction) < 0)};
      append(first, numbers_of(normal));
      append(first, numbers_of(texcoord));
    }
    out.push_back(count);
    append(out, first);
  }
  double area = 0;
  for (std::size_t at = 0; at < wall.indices.size(); at += 3) {
    const std::array<glm::dvec3, 3> corners = corners_at(at);
    area += glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
  }
  out.push_back(area);
  return out;
}

}  // namespace atelier
