#include "scene/shape_detail.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace atelier::shape_detail {

void require_count(const char* shape, const char* name, int value, int low, int high) {
  if (value < low || value > high)
    throw Error(fmt::format("{}: {} {} (allowed: {}..{})", shape, name, value, low, high));
}

void require_length(const char* shape, const char* name, float value) {
  if (!(value >= 1e-6f && value <= 1e6f))
    throw Error(fmt::format("{}: {} {} m (allowed: 1e-6..1e6)", shape, name, value));
}

glm::dvec2 circle_point(int i, int n) {
  i %= n;
  // Compute sine and cosine in the first quarter only; the other quarters are rotations of it.
  const std::int64_t quarters = std::int64_t(i) * 4 / n;
  const double angle = 2 * std::numbers::pi * (double(i) - double(quarters * n) / 4) / n;
  const glm::dvec2 p(std::cos(angle), std::sin(angle));
  switch (quarters) {
    case 0:
      return p;
    case 1:
      return {-p.y, p.x};
    case 2:
      return {-p.x, -p.y};
    default:
      return {p.y, -p.x};
  }
}

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const glm::vec3 &pa = mesh.vertices[a].position, &pb = mesh.vertices[b].position, &pc = mesh.vertices[c].position;
  if (pa == pb || pb == pc || pc == pa) return;
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

void add_grid(Mesh& mesh, int columns, int rows, const GridVertex& vertex) {
  const auto first = std::uint32_t(mesh.vertices.size());
  const auto at = [&](int column, int row) { return first + std::uint32_t(row) * (columns + 1) + column; };
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) mesh.vertices.push_back(vertex(column, row));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      add_triangle(mesh, at(column, row), at(column + 1, row), at(column + 1, row + 1));
      add_triangle(mesh, at(column, row), at(column + 1, row + 1), at(column, row + 1));
    }
}

void append(Mesh& mesh, const Mesh& other) {
  const auto first = std::uint32_t(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  mesh.tangents.insert(mesh.tangents.end(), other.tangents.begin(), other.tangents.end());
  for (const std::uint32_t index : other.indices) mesh.indices.push_back(first + index);
}

void turn_inside_out(Mesh& mesh) {
  for (Vertex& vertex : mesh.vertices) vertex.normal = -vertex.normal;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
}

}  // namespace atelier::shape_detail
