#include "scene_import/tangents.hpp"

#include <bit>
#include <unordered_map>

#include "scene/standard_tangents.hpp"

namespace atelier::scene_import {
namespace {

/// A further tangent of a vertex.
struct SplitKey {
  std::uint32_t vertex;
  glm::vec4 tangent;
  bool operator==(const SplitKey&) const = default;
};

struct SplitKeyHash {
  std::size_t operator()(const SplitKey& key) const {
    std::uint64_t h = key.vertex;
    for (int i = 0; i < 4; ++i) {
      h = (h ^ std::bit_cast<std::uint32_t>(key.tangent[i] + 0.0f)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
    return h;
  }
};

/// Whether the texture coordinates of any triangle span an area.
bool spans_texture(const Mesh& mesh) {
  for (std::size_t at = 0; at + 2 < mesh.indices.size(); at += 3) {
    const auto texcoord = [&](std::size_t k) { return mesh.vertices[mesh.indices[at + k]].texcoord; };
    const glm::vec2 a = texcoord(1) - texcoord(0), b = texcoord(2) - texcoord(0);
    if (a.x * b.y != a.y * b.x) return true;
  }
  return false;
}

}  // namespace

void add_standard_tangents(Mesh& mesh) {
  if (!spans_texture(mesh)) return;
  const std::vector<glm::vec4> corners = standard_tangents(mesh);
  std::vector<bool> known(mesh.vertices.size(), false);
  std::unordered_map<SplitKey, std::uint32_t, SplitKeyHash> copies;
  mesh.tangents.assign(mesh.vertices.size(), {1, 0, 0, -1});  // for vertices that no triangle uses
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const std::uint32_t vertex = mesh.indices[c];
    if (!known[vertex]) {
      known[vertex] = true;
      mesh.tangents[vertex] = corners[c];
    }
    if (mesh.tangents[vertex] == corners[c]) continue;
    const auto next = std::uint32_t(mesh.vertices.size());
    const auto [copy, added] = copies.try_emplace({vertex, corners[c]}, next);
    if (added) {
      mesh.vertices.push_back(Vertex(mesh.vertices[vertex]));
      mesh.tangents.push_back(corners[c]);
    }
    mesh.indices[c] = copy->second;
  }
}

}  // namespace atelier::scene_import
