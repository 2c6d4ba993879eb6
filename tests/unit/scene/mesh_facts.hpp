// What can be measured on a mesh, for the tests of shapes and importers.
#pragma once

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "scene/scene.hpp"

namespace atelier::test {

struct MeshFacts {
  bool finite = true;
  double normal_length_error = 0;  ///< largest | |n| - 1 |
  double least_agreement = 1;      ///< smallest cosine between a triangle's own normal and its corners' normals
  double least_area = 1e300;       ///< of a triangle, m^2
  glm::vec2 low_texcoord{1e9f}, high_texcoord{-1e9f};
  int mirrored = 0;    ///< triangles whose texture, seen from the front, runs the wrong way round
  int euler = 0;       ///< corners - edges + faces, corners at equal places taken as one
  bool closed = true;  ///< every edge is walked once in each direction
  double volume = 0;   ///< m^3, by the divergence theorem; positive where the front is outside
};

inline MeshFacts measure(const Mesh& mesh) {
  MeshFacts facts;
  using Place = std::tuple<float, float, float>;
  std::map<Place, int> places;
  std::vector<int> place_of;
  for (const Vertex& v : mesh.vertices) {
    for (int i = 0; i < 3; ++i) facts.finite &= std::isfinite(v.position[i]) && std::isfinite(v.normal[i]);
    facts.finite &= std::isfinite(v.texcoord.x) && std::isfinite(v.texcoord.y);
    facts.normal_length_error =
        std::max(facts.normal_length_error, std::abs(double(glm::length(glm::dvec3(v.normal))) - 1));
    facts.low_texcoord = glm::min(facts.low_texcoord, v.texcoord);
    facts.high_texcoord = glm::max(facts.high_texcoord, v.texcoord);
    // Adding zero turns -0 into +0, which compare equal but would print differently.
    const Place place{v.position.x + 0.0f, v.position.y + 0.0f, v.position.z + 0.0f};
    place_of.push_back(places.try_emplace(place, int(places.size())).first->second);
  }
  std::map<std::pair<int, int>, int> edges;  // directed, how often
  std::set<int> used;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const std::uint32_t* corner = &mesh.indices[t];
    const glm::dvec3 a = mesh.vertices[corner[0]].position, b = mesh.vertices[corner[1]].position,
                     c = mesh.vertices[corner[2]].position;
    const glm::dvec3 twice_area = glm::cross(b - a, c - a);
    facts.least_area = std::min(facts.least_area, glm::length(twice_area) / 2);
    facts.volume += glm::dot(a, twice_area) / 6;
    const auto uv = [&](int i) { return glm::dvec2(mesh.vertices[corner[i]].texcoord); };
    const glm::dvec2 e = uv(1) - uv(0), f = uv(2) - uv(0);
    facts.mirrored += e.x * f.y - e.y * f.x < 0;
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 n = mesh.vertices[corner[i]].normal;
      facts.least_agreement = std::min(facts.least_agreement, glm::dot(n, glm::normalize(twice_area)));
      ++edges[{place_of[corner[i]], place_of[corner[(i + 1) % 3]]}];
      used.insert(place_of[corner[i]]);
    }
  }
  for (const auto& [edge, times] : edges) facts.closed &= times == 1 && edges.contains({edge.second, edge.first});
  facts.euler = int(used.size()) - int(edges.size()) / 2 + int(mesh.indices.size() / 3);
  return facts;
}

}  // namespace atelier::test
