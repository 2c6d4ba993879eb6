#include "oracle/tangents.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace atelier::oracle {

namespace {

using Triangle = std::array<const Vertex*, 3>;

/// The gradient of position by u in a triangle whose position is P(u, v), and whether the texture is mirrored; nothing
/// for a degenerate triangle. By Cramer's rule on P(b) - P(a) = P_u du + P_v dv.
struct Direction {
  glm::dvec3 along_u;
  bool mirrored;
};
std::optional<Direction> direction_of(const Triangle& t) {
  constexpr double least = 1e-6;  // of the contract
  std::array<glm::dvec3, 3> edges;
  std::array<glm::dvec2, 3> sides;
  double longest_edge = 0, longest_side = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    edges[k] = glm::dvec3(t[(k + 1) % 3]->position) - glm::dvec3(t[k]->position);
    sides[k] = glm::dvec2(t[(k + 1) % 3]->texcoord) - glm::dvec2(t[k]->texcoord);
    longest_edge = std::max(longest_edge, glm::length(edges[k]));
    longest_side = std::max(longest_side, glm::length(sides[k]));
  }
  const double twice_area = sides[0].x * -sides[2].y + sides[0].y * sides[2].x;
  if (glm::length(glm::cross(edges[0], edges[2])) <= least * longest_edge * longest_edge ||
      std::abs(twice_area) <= least * longest_side * longest_side)
    return std::nullopt;
  return Direction{glm::normalize((edges[0] * -sides[2].y + edges[2] * sides[0].y) / twice_area), twice_area < 0};
}

/// The angle at corner k, radians.
double angle_at(const Triangle& t, std::size_t k) {
  const glm::dvec3 here(t[k]->position);
  const glm::dvec3 a = glm::normalize(glm::dvec3(t[(k + 1) % 3]->position) - here),
                   b = glm::normalize(glm::dvec3(t[(k + 2) % 3]->position) - here);
  return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
}

/// The part of `v` that is perpendicular to a unit vector.
glm::dvec3 across(const glm::dvec3& v, const glm::dvec3& unit) {
  return v - glm::dot(v, unit) * unit;
}

struct Sum {
  glm::dvec3 direction{0};
  double angles = 0, mirrored_angles = 0;
};

}  // namespace

std::vector<glm::dvec4> tangents_of(const Mesh& mesh) {
  if (!mesh.tangents.empty()) return {mesh.tangents.begin(), mesh.tangents.end()};
  std::vector<Sum> sums(mesh.vertices.size());
  for (std::size_t at = 0; at + 2 < mesh.indices.size(); at += 3) {
    const Triangle triangle{&mesh.vertices[mesh.indices[at]], &mesh.vertices[mesh.indices[at + 1]],
                            &mesh.vertices[mesh.indices[at + 2]]};
    const auto direction = direction_of(triangle);
    if (!direction) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      Sum& sum = sums[mesh.indices[at + k]];
      const double angle = angle_at(triangle, k);
      const glm::dvec3 flat = across(direction->along_u, glm::dvec3(triangle[k]->normal));
      if (glm::length(flat) > 1e-6) sum.direction += angle * glm::normalize(flat);
      sum.angles += angle;
      if (direction->mirrored) sum.mirrored_angles += angle;
    }
  }
  std::vector<glm::dvec4> tangents;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const Sum& sum = sums[v];
    const glm::dvec3 normal(mesh.vertices[v].normal);
    const bool none = normal == glm::dvec3(0) || glm::length(sum.direction) <= 1e-4 * sum.angles;
    tangents.push_back(none ? glm::dvec4(0)
                            : glm::dvec4(glm::normalize(across(sum.direction, normal)),
                                         2 * sum.mirrored_angles > sum.angles ? -1.0 : 1.0));
  }
  return tangents;
}

}  // namespace atelier::oracle
