#include "scene_import/normals.hpp"

#include <algorithm>
#include <cmath>

namespace atelier::scene_import {
namespace {

/// The normal of a triangle; its length is twice the area.
glm::dvec3 area_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::cross(b - a, c - a);
}

/// Normalises; scales by the largest component first, so that squares of 1e-200 and 1e200 do not underflow or overflow.
glm::vec3 direction_or_up(const glm::dvec3& v) {
  const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(size > 0) || !std::isfinite(size)) return {0, 1, 0};
  return glm::vec3(glm::normalize(v / size));
}

/// The facets at each position: those of position p are list[first[p] .. first[p + 1]).
struct Around {
  std::vector<std::size_t> first;
  std::vector<std::uint32_t> list;
};

Around facets_around(std::size_t positions, const std::vector<Facet>& facets) {
  Around around{std::vector<std::size_t>(positions + 1, 0), std::vector<std::uint32_t>(3 * facets.size())};
  for (const Facet& facet : facets)
    for (const std::uint32_t p : facet.corners) ++around.first[p + 1];
  for (std::size_t p = 0; p < positions; ++p) around.first[p + 1] += around.first[p];
  std::vector<std::size_t> next(around.first.begin(), around.first.end() - 1);
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (const std::uint32_t p : facets[f].corners) around.list[next[p]++] = std::uint32_t(f);
  return around;
}

/// The angle of a triangle at corner a, in radians; 0 if the triangle has no area.
double corner_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const double sine = glm::length(area_normal(a, b, c));
  return sine == 0 ? 0 : std::atan2(sine, glm::dot(b - a, c - a));
}

int place_in(const Facet& facet, std::uint32_t corner) {
  return facet.corners[0] == corner ? 0 : facet.corners[1] == corner ? 1 : 2;
}

}  // namespace

std::vector<std::array<glm::vec3, 3>> facet_normals(const std::vector<glm::vec3>& positions,
                                                    const std::vector<Facet>& facets) {
  std::vector<glm::vec3> unit(facets.size());
  std::vector<std::array<float, 3>> angles(facets.size());
  std::vector<glm::dvec3> all(positions.size(), glm::dvec3(0));
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto& corners = facets[f].corners;
    const glm::dvec3 p[3] = {positions[corners[0]], positions[corners[1]], positions[corners[2]]};
    unit[f] = direction_or_up(area_normal(p[0], p[1], p[2]));
    for (int i = 0; i < 3; ++i) {
      angles[f][i] = float(corner_angle(p[i], p[(i + 1) % 3], p[(i + 2) % 3]));
      all[corners[i]] += double(angles[f][i]) * glm::dvec3(unit[f]);
    }
  }

  // Comparing all pairs of neighbours at a corner takes quadratic time. Hundreds meet at the tip of a cone; if there
  // are even more, all are averaged.
  constexpr std::size_t most_neighbours = 512;
  const Around around = facets_around(positions.size(), facets);
  std::vector<std::array<glm::vec3, 3>> normals(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const int group = facets[f].smoothing;
      const std::uint32_t corner = facets[f].corners[i];
      const std::size_t begin = around.first[corner], end = around.first[corner + 1];
      if (group == 0 || end - begin > most_neighbours) {
        normals[f][i] = group == 0 ? unit[f] : direction_or_up(all[corner]);
        continue;
      }
      glm::dvec3 sum(0);
      for (std::size_t k = begin; k < end; ++k) {
        const std::uint32_t other = around.list[k];
        const bool bends_little = glm::dot(unit[f], unit[other]) > 0.5f;  // cos 60 degrees
        if (facets[other].smoothing == group && (group > 0 || bends_little))
          sum += double(angles[other][place_in(facets[other], corner)]) * glm::dvec3(unit[other]);
      }
      normals[f][i] = sum == glm::dvec3(0) ? unit[f] : direction_or_up(sum);
    }
  return normals;
}

void make_flat(Mesh& mesh) {
  std::vector<Vertex> vertices;
  std::vector<glm::vec4> tangents;
  vertices.reserve(mesh.indices.size());
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const std::uint32_t* corner = &mesh.indices[t];
    const glm::vec3 normal = direction_or_up(area_normal(
        mesh.vertices[corner[0]].position, mesh.vertices[corner[1]].position, mesh.vertices[corner[2]].position));
    for (int i = 0; i < 3; ++i) {
      vertices.push_back(mesh.vertices[corner[i]]);
      vertices.back().normal = normal;
      if (!mesh.tangents.empty()) tangents.push_back(mesh.tangents[corner[i]]);
    }
  }
  mesh.vertices = std::move(vertices);
  mesh.tangents = std::move(tangents);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) mesh.indices[i] = std::uint32_t(i);
}

std::size_t fix_normals(Mesh& mesh) {
  const auto is_direction = [](const glm::vec3& n) {
    const float size = glm::dot(n, n);
    return std::isfinite(size) && size > 1e-12f;
  };
  std::size_t broken = 0;
  for (Vertex& vertex : mesh.vertices) {
    if (is_direction(vertex.normal))
      vertex.normal = glm::normalize(vertex.normal);
    else
      ++broken;
  }
  if (broken == 0) return 0;

  std::vector<glm::dvec3> sums(mesh.vertices.size(), glm::dvec3(0));
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const std::uint32_t* corner = &mesh.indices[t];
    const glm::dvec3 n = area_normal(mesh.vertices[corner[0]].position, mesh.vertices[corner[1]].position,
                                     mesh.vertices[corner[2]].position);
    for (int i = 0; i < 3; ++i) sums[corner[i]] += n;
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (!is_direction(mesh.vertices[i].normal)) mesh.vertices[i].normal = direction_or_up(sums[i]);
  return broken;
}

}  // namespace atelier::scene_import
