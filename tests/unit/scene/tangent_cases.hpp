// Small meshes for tangents, with those that another implementation of the standard gives for them.
#pragma once

#include <initializer_list>
#include <vector>

#include "scene/scene.hpp"

namespace atelier::test {

inline void add_triangles(Mesh& mesh, std::initializer_list<std::uint32_t> indices) {
  mesh.indices.insert(mesh.indices.end(), indices);
}

/// Two rows of two quads along a bent strip. The texture is mirrored in the middle, at x = 0; the halves share
/// vertices.
inline Mesh mirrored_strip() {
  Mesh mesh{.name = "mirrored strip"};
  for (int row = 0; row < 3; ++row)
    for (int column = -1; column < 2; ++column)
      mesh.vertices.push_back({{column, row + 0.25f * column, -0.5f * column * column},
                               glm::normalize(glm::vec3(column, 0.125f * row, 1)),
                               {column * column * 0.75f, row * 0.5f + column * 0.125f}});
  for (const std::uint32_t first : {0, 1, 3, 4})
    add_triangles(mesh, {first, first + 1, first + 4, first, first + 4, first + 3});
  return mesh;
}

/// A pyramid with one vertex at its tip, where the directions of opposite sides are opposite.
inline Mesh pole() {
  Mesh mesh{.name = "pole", .vertices = {{{0, 1, 0}, {0, 1, 0}, {0.5f, 1}}}};
  const glm::vec3 around[] = {{1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 0, 1}, {1, 0, 0}};
  for (int i = 0; i < 5; ++i) mesh.vertices.push_back({around[i], around[i], {0.25f * i, 0}});
  for (std::uint32_t i = 1; i < 5; ++i) add_triangles(mesh, {i, i + 1, 0});
  return mesh;
}

/// Three triangles in a row, the middle one without an area in the texture, and one with its corners on a line; one
/// with two corners at one place, then one with all three; at that place one without an area in the texture, away from
/// all others.
inline Mesh degenerate_triangles() {
  const glm::vec3 up(0, 0, 1), aside = glm::normalize(glm::vec3(1, 0, 2));
  Mesh mesh{.name = "degenerate triangles"};
  mesh.vertices = {{{0, 0, 0}, up, {0, 0}},     {{1, 0, 0}, up, {1, 0.5f}},
                   {{0, 1, 0.25f}, up, {0, 1}}, {{1, 1, 0}, aside, {0.5f, 0.75f}},
                   {{2, 1, -1}, up, {1, 1}},    {{0, -1, 1}, up, {1.5f, 0}},
                   {{1, 0, 0}, up, {1, 0.5f}},  {{5, 5, 5}, aside, {0, 0}},
                   {{6, 5, 5}, up, {0, 0}},     {{5, 6, 5}, up, {0, 0}}};
  add_triangles(mesh, {0, 1, 2, 1, 3, 2, 1, 4, 3, 4, 1, 5, 6, 1, 2, 7, 7, 7, 7, 8, 9});
  return mesh;
}

/// A mesh, and the tangent of each corner as the other implementation gives it.
struct KnownTangents {
  Mesh mesh;
  std::vector<glm::vec4> tangents;
};

/// From the npm package mikktspace 1.1.1, Mikkelsen's algorithm as WebAssembly: generateTangents(positions, normals,
/// texcoords) of the meshes above, three numbers or two for each index, eight digits of each result.
inline std::vector<KnownTangents> known_tangents() {
  return {
      {mirrored_strip(),
       {{-0.70710677f, 0, -0.70710677f, -1},
        {-1, 0, 0, -1},
        {-0.99808246f, 0.061420463f, -0.0076775742f, -1},
        {-0.70710677f, 0, -0.70710677f, -1},
        {-0.99808246f, 0.061420463f, -0.0076775742f, -1},
        {-0.70862883f, -0.029221807f, -0.70497614f, -1},
        {1, 0, 0, 1},
        {0.70710683f, 0, -0.70710683f, 1},
        {0.70862889f, -0.029221809f, -0.70497608f, 1},
        {1, 0, 0, 1},
        {0.70862889f, -0.029221809f, -0.70497608f, 1},
        {0.99808246f, 0.061420467f, -0.0076775742f, 1},
        {-0.70862883f, -0.029221807f, -0.70497614f, -1},
        {-0.99808246f, 0.061420463f, -0.0076775742f, -1},
        {-0.99272722f, 0.11679143f, -0.029197831f, -1},
        {-0.70862883f, -0.029221807f, -0.70497614f, -1},
        {-0.99272722f, 0.11679143f, -0.029197831f, -1},
        {-0.71304989f, -0.057043988f, -0.69878888f, -1},
        {0.99808246f, 0.061420467f, -0.0076775742f, 1},
        {0.70862889f, -0.029221809f, -0.70497608f, 1},
        {0.71304995f, -0.057043992f, -0.69878888f, 1},
        {0.99808246f, 0.061420467f, -0.0076775742f, 1},
        {0.71304995f, -0.057043992f, -0.69878888f, 1},
        {0.99272716f, 0.11679144f, -0.029197833f, 1}}},
      {pole(),
       {{0, 0, -1, 1},
        {-1, 0, 0, 1},
        {-0.70710677f, 0, -0.70710677f, 1},
        {-1, 0, 0, 1},
        {0, 0, 1, 1},
        {-0.70710677f, 0, 0.70710677f, 1},
        {0, 0, 1, 1},
        {1, 0, 0, 1},
        {0.70710677f, 0, 0.70710677f, 1},
        {1, 0, 0, 1},
        {0, 0, -1, 1},
        {0.70710677f, 0, -0.70710677f, 1}}},
      {degenerate_triangles(),
       {{0.89442718f, -0.44721359f, 0, 1},
        {0.8112421f, -0.58471024f, 0, 1},
        {0.89442718f, -0.44721359f, 0, 1},
        {0.8112421f, -0.58471024f, 0, 1},
        {0.7171371f, -0.59761429f, -0.35856855f, 1},
        {0.89442718f, -0.44721359f, 0, 1},
        {0.8112421f, -0.58471024f, 0, 1},
        {0.70710677f, -0.70710677f, 0, 1},
        {0.7171371f, -0.59761429f, -0.35856855f, 1},
        {0.70710677f, -0.70710677f, 0, 1},
        {0.8112421f, -0.58471024f, 0, 1},
        {1, 0, 0, -1},
        {0.8112421f, -0.58471024f, 0, 1},
        {0.8112421f, -0.58471024f, 0, 1},
        {0.89442718f, -0.44721359f, 0, 1},
        {1, 0, 0, -1},
        {1, 0, 0, -1},
        {1, 0, 0, -1},
        {1, 0, 0, -1},
        {1, 0, 0, -1},
        {1, 0, 0, -1}}},
  };
}

}  // namespace atelier::test
