#include "scene/standard_tangents.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

namespace atelier {
namespace {

constexpr auto none = std::numeric_limits<std::uint32_t>::max();

/// A triangle whose corners are at three different places.
struct TangentTriangle {
  std::uint32_t first;                                    ///< its first corner in Mesh::indices
  std::array<std::uint32_t, 3> vertices;                  ///< welded
  std::array<std::uint32_t, 3> across{none, none, none};  ///< the neighbour at the edge from each corner to the next
  std::array<std::uint32_t, 3> groups{none, none, none};  ///< of each corner
  glm::vec3 along_u{0}, along_v{0};                       ///< the position's derivatives, normalised
  bool mapped = false;  ///< whether it has an area in the texture; if not, it joins any group
  bool mirrored = false;
};

/// Triangles around a vertex that share a tangent.
struct TangentGroup {
  glm::vec3 first_u{0}, first_v{0};  ///< of one of them
  glm::vec3 sum{0};                  ///< of the directions, weighted by the angles
  bool mirrored = false;
  bool started = false;
  bool wide = false;  ///< whether directions may be opposite
};

/// A triangle seen from one of its corners, projected into the plane perpendicular to the normal there.
struct TangentCorner {
  glm::vec3 along_u, along_v;  ///< of unit length, or zero
  float angle;                 ///< radians
};

/// The smallest normal float is the standard's limit to zero.
bool not_zero(float x) {
  return std::abs(x) > std::numeric_limits<float>::min();
}

glm::vec3 unit_or_short(const glm::vec3& v) {
  if (!not_zero(v.x) && !not_zero(v.y) && !not_zero(v.z)) return v;
  return (1 / std::sqrt(glm::dot(v, v))) * v;
}

glm::vec3 in_plane(const glm::vec3& v, const glm::vec3& normal) {
  return unit_or_short(v - glm::dot(normal, v) * normal);
}

/// Bits that are equal where vertices are: adding zero turns -0 into 0.
std::array<std::uint32_t, 8> bits_of(const Vertex& v) {
  const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x + 0.0f); };
  return {bits(v.position.x), bits(v.position.y), bits(v.position.z), bits(v.normal.x),
          bits(v.normal.y),   bits(v.normal.z),   bits(v.texcoord.x), bits(v.texcoord.y)};
}

std::uint64_t hash_of(const std::array<std::uint32_t, 8>& words) {
  std::uint64_t h = 0;
  for (std::size_t i = 0; i < words.size(); i += 2) {
    h = (h ^ (std::uint64_t(words[i]) << 32 | words[i + 1])) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return h;
}

/// For each vertex the first that equals it, by open addressing.
std::vector<std::uint32_t> weld(const std::vector<Vertex>& vertices) {
  std::vector<std::uint32_t> table(std::bit_ceil(2 * vertices.size() + 1), none);
  std::vector<std::uint32_t> welded(vertices.size());
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const auto bits = bits_of(vertices[v]);
    std::size_t place = hash_of(bits) & (table.size() - 1);
    while (table[place] != none && bits_of(vertices[table[place]]) != bits) place = (place + 1) & (table.size() - 1);
    if (table[place] == none) table[place] = v;
    welded[v] = table[place];
  }
  return welded;
}

/// The derivatives by the texture coordinates, up to positive factors.
void differentiate(TangentTriangle& triangle, const Vertex& a, const Vertex& b, const Vertex& c) {
  const glm::vec2 s = b.texcoord - a.texcoord, t = c.texcoord - a.texcoord;
  const glm::vec3 d = b.position - a.position, e = c.position - a.position;
  const float twice_area = s.x * t.y - s.y * t.x;
  const glm::vec3 u = t.y * d - s.y * e, v = -t.x * d + s.x * e;
  triangle.mirrored = !(twice_area > 0);
  if (!not_zero(twice_area)) return;
  const float sign = triangle.mirrored ? -1.0f : 1.0f, size = std::abs(twice_area);
  const float length_u = std::sqrt(glm::dot(u, u)), length_v = std::sqrt(glm::dot(v, v));
  triangle.along_u = not_zero(length_u) ? sign / length_u * u : u;
  triangle.along_v = not_zero(length_v) ? sign / length_v * v : v;
  triangle.mapped = not_zero(length_u / size) && not_zero(length_v / size);
}

std::vector<TangentTriangle> triangles_of(const Mesh& mesh, const std::vector<std::uint32_t>& welded) {
  std::vector<TangentTriangle> triangles;
  triangles.reserve(mesh.indices.size() / 3);
  for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
    const std::uint32_t* corner = &mesh.indices[first];
    const Vertex &a = mesh.vertices[corner[0]], &b = mesh.vertices[corner[1]], &c = mesh.vertices[corner[2]];
    if (a.position == b.position || b.position == c.position || c.position == a.position) continue;
    triangles.push_back(
        {.first = std::uint32_t(first), .vertices = {welded[corner[0]], welded[corner[1]], welded[corner[2]]}});
    differentiate(triangles.back(), a, b, c);
  }
  return triangles;
}

/// An edge at the lower of its two vertices.
struct TangentEdge {
  std::uint32_t higher;  ///< the other vertex
  std::uint32_t triangle;
  std::uint8_t corner;  ///< from which the triangle runs along the edge
  bool rises;           ///< whether it starts at the lower vertex
  auto operator<=>(const TangentEdge&) const = default;
};

/// All edges by their lower vertices: those of vertex v are list[first[v] .. first[v + 1]).
struct TangentEdges {
  std::vector<std::uint32_t> first;
  std::vector<TangentEdge> list;
};

TangentEdges edges_of(const std::vector<TangentTriangle>& triangles, std::size_t vertices) {
  TangentEdges edges{std::vector<std::uint32_t>(vertices + 1, 0), std::vector<TangentEdge>(3 * triangles.size())};
  for (const TangentTriangle& t : triangles)
    for (int i = 0; i < 3; ++i) ++edges.first[std::min(t.vertices[i], t.vertices[(i + 1) % 3]) + 1];
  for (std::size_t v = 0; v < vertices; ++v) edges.first[v + 1] += edges.first[v];
  std::vector<std::uint32_t> next(edges.first.begin(), edges.first.end() - 1);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint8_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangles[t].vertices[i], to = triangles[t].vertices[(i + 1) % 3];
      edges.list[next[std::min(from, to)]++] = {std::max(from, to), t, i, from < to};
    }
  return edges;
}

/// Joins triangles that run along the same edge in opposite directions: the first of each direction, the second, ...
void join(std::vector<TangentTriangle>& triangles, const TangentEdge* begin, const TangentEdge* end) {
  const TangentEdge *rising = begin, *falling = begin;
  while (true) {
    rising = std::find_if(rising, end, [](const TangentEdge& e) { return e.rises; });
    falling = std::find_if(falling, end, [](const TangentEdge& e) { return !e.rises; });
    if (rising == end || falling == end) return;
    triangles[rising->triangle].across[rising->corner] = falling->triangle;
    triangles[falling->triangle].across[falling->corner] = rising->triangle;
    ++rising, ++falling;
  }
}

/// mikktspace.c leaves the edges of the last vertex unsorted and so may miss neighbours there; here all are found.
void find_neighbours(std::vector<TangentTriangle>& triangles, std::size_t vertices) {
  TangentEdges edges = edges_of(triangles, vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    TangentEdge *begin = edges.list.data() + edges.first[v], *const last = edges.list.data() + edges.first[v + 1];
    std::sort(begin, last);
    while (begin != last) {
      const TangentEdge* end =
          std::find_if(begin, last, [&](const TangentEdge& e) { return e.higher != begin->higher; });
      join(triangles, begin, end);
      begin += end - begin;
    }
  }
}

/// Collects the group of a corner: the triangles around its vertex that are connected by edges.
void spread(std::vector<TangentTriangle>& triangles, std::uint32_t seed, int corner, std::uint32_t group,
            std::vector<std::uint32_t>& open) {
  const std::uint32_t vertex = triangles[seed].vertices[corner];
  const bool mirrored = triangles[seed].mirrored;
  open.assign(1, seed);
  while (!open.empty()) {
    TangentTriangle& t = triangles[open.back()];
    open.pop_back();
    const int i = t.vertices[0] == vertex ? 0 : t.vertices[1] == vertex ? 1 : 2;
    if (t.groups[i] != none) continue;
    // The first group that reaches a triangle without texture area decides how it is mirrored.
    if (!t.mapped && t.groups == std::array{none, none, none}) t.mirrored = mirrored;
    if (t.mirrored != mirrored) continue;
    t.groups[i] = group;
    for (const std::uint32_t next : {t.across[i], t.across[(i + 2) % 3]})
      if (next != none) open.push_back(next);
  }
}

std::vector<TangentGroup> make_groups(std::vector<TangentTriangle>& triangles) {
  std::vector<TangentGroup> groups;
  std::vector<std::uint32_t> open;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (triangles[t].mapped && triangles[t].groups[i] == none) {
        spread(triangles, t, i, std::uint32_t(groups.size()), open);
        groups.push_back({.mirrored = triangles[t].mirrored});
      }
  return groups;
}

TangentCorner corner_of(const Mesh& mesh, const TangentTriangle& triangle, int i) {
  const auto vertex = [&](int k) -> const Vertex& { return mesh.vertices[triangle.vertices[k % 3]]; };
  const glm::vec3 &here = vertex(i).position, &normal = vertex(i).normal;
  const glm::vec3 to_last = in_plane(vertex(i + 2).position - here, normal),
                  to_next = in_plane(vertex(i + 1).position - here, normal);
  return {in_plane(triangle.along_u, normal), in_plane(triangle.along_v, normal),
          std::acos(std::clamp(glm::dot(to_last, to_next), -1.0f, 1.0f))};
}

void sum_directions(const Mesh& mesh, const std::vector<TangentTriangle>& triangles,
                    std::vector<TangentGroup>& groups) {
  for (const TangentTriangle& t : triangles)
    for (int i = 0; t.mapped && i < 3; ++i) {
      TangentGroup& group = groups[t.groups[i]];
      const TangentCorner corner = corner_of(mesh, t, i);
      if (!group.started) {
        group.first_u = corner.along_u;
        group.first_v = corner.along_v;
        group.started = true;
      }
      // Within 90 degrees of one direction, no two are opposite.
      group.wide |= !(glm::dot(group.first_u, corner.along_u) > 0 && glm::dot(group.first_v, corner.along_v) > 0);
      group.sum += corner.angle * corner.along_u;
    }
}

glm::vec4 tangent_of(const glm::vec3& sum, bool mirrored) {
  const glm::vec3 unit = unit_or_short(sum);
  const float size = glm::dot(unit, unit);
  return {size > 0.5f && size < 2 ? unit : glm::vec3(1, 0, 0), mirrored ? -1.0f : 1.0f};
}

/// A corner of a wide group.
struct WideCorner {
  std::uint32_t group, triangle;
  int corner;
};

/// The corners of one group, each with the mean of those that are not opposite to it: at a threshold of 180 degrees the
/// standard still separates directions whose cosine is -1 in floats, as at the pole of a sphere.
void separate_opposites(const Mesh& mesh, const std::vector<TangentTriangle>& triangles, const TangentGroup& group,
                        std::span<const WideCorner> members, std::vector<glm::vec4>& tangents) {
  std::vector<TangentCorner> corners;
  for (const WideCorner& m : members) corners.push_back(corner_of(mesh, triangles[m.triangle], m.corner));
  for (std::size_t i = 0; i < members.size(); ++i) {
    const bool mapped = triangles[members[i].triangle].mapped;
    glm::vec3 sum(0);
    for (std::size_t k = 0; k < members.size(); ++k) {
      if (!triangles[members[k].triangle].mapped) continue;
      const bool opposite = !(glm::dot(corners[i].along_u, corners[k].along_u) > -1 &&
                              glm::dot(corners[i].along_v, corners[k].along_v) > -1);
      if (i == k || !mapped || !opposite) sum += corners[k].angle * corners[k].along_u;
    }
    tangents[triangles[members[i].triangle].first + members[i].corner] = tangent_of(sum, group.mirrored);
  }
}

void separate_wide_groups(const Mesh& mesh, const std::vector<TangentTriangle>& triangles,
                          const std::vector<TangentGroup>& groups, std::vector<glm::vec4>& tangents) {
  // All pairs take quadratic time: beyond this many, directions cancel out anyway, and all are averaged.
  constexpr std::size_t most_compared = 512;
  std::vector<WideCorner> wide;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (const std::uint32_t group = triangles[t].groups[i]; group != none && groups[group].wide)
        wide.push_back({group, t, i});
  std::ranges::stable_sort(wide, {}, &WideCorner::group);
  for (std::size_t begin = 0, end = 0; begin < wide.size(); begin = end) {
    while (end < wide.size() && wide[end].group == wide[begin].group) ++end;
    if (end - begin <= most_compared)
      separate_opposites(mesh, triangles, groups[wide[begin].group], {&wide[begin], end - begin}, tangents);
  }
}

/// Gives the corners of triangles with two corners at one place the tangent of another triangle's corner.
void fill_degenerate(const Mesh& mesh, const std::vector<std::uint32_t>& welded,
                     const std::vector<TangentTriangle>& triangles, std::vector<glm::vec4>& tangents) {
  if (3 * triangles.size() == mesh.indices.size()) return;
  std::vector<std::uint32_t> sound(mesh.vertices.size(), none);  // the first such corner of each welded vertex
  std::vector<bool> done(mesh.indices.size(), false);
  for (const TangentTriangle& t : triangles)
    for (std::uint32_t i = 0; i < 3; ++i) {
      done[t.first + i] = true;
      if (sound[t.vertices[i]] == none) sound[t.vertices[i]] = t.first + i;
    }
  for (std::size_t c = 0; c < mesh.indices.size(); ++c)
    if (const std::uint32_t other = sound[welded[mesh.indices[c]]]; !done[c] && other != none)
      tangents[c] = tangents[other];
}

}  // namespace

std::vector<glm::vec4> standard_tangents(const Mesh& mesh) {
  const std::vector<std::uint32_t> welded = weld(mesh.vertices);
  std::vector<TangentTriangle> triangles = triangles_of(mesh, welded);
  find_neighbours(triangles, mesh.vertices.size());
  std::vector<TangentGroup> groups = make_groups(triangles);
  sum_directions(mesh, triangles, groups);

  std::vector<glm::vec4> tangents(mesh.indices.size(), glm::vec4(1, 0, 0, -1));
  for (const TangentTriangle& t : triangles)
    for (int i = 0; i < 3; ++i)
      if (t.groups[i] != none)
        tangents[t.first + i] = tangent_of(groups[t.groups[i]].sum, groups[t.groups[i]].mirrored);
  separate_wide_groups(mesh, triangles, groups, tangents);
  fill_degenerate(mesh, welded, triangles, tangents);
  return tangents;
}

}  // namespace atelier
