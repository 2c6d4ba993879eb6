// Box, plane, disc, cylinder and cone: shapes with flat and singly curved faces.
#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "scene/shape_detail.hpp"
#include "scene/shapes.hpp"

namespace atelier {

using namespace shape_detail;

namespace {

constexpr int most_segments = 65536;

/// A corner of a regular polygon in the xz plane, counter-clockwise from +x seen from above, exact at quarter turns.
glm::dvec3 around_y(int i, int n) {
  const glm::dvec2 p = circle_point(i, n);
  return {p.x, 0, -p.y};
}

void require_repeat(const char* shape, const glm::vec2& repeat) {
  for (const float times : {repeat.x, repeat.y})
    if (!(times >= 1e-3f && times <= 1e4f))
      throw Error(fmt::format("{}: repeat {} (allowed: 0.001..10000)", shape, times));
}

}  // namespace

Mesh make_box(const BoxShape& shape) {
  for (int i = 0; i < 3; ++i) require_length("box", i == 0 ? "size.x" : i == 1 ? "size.y" : "size.z", shape.size[i]);

  // Each face by its right and up directions, seen from outside.
  struct Face {
    glm::vec3 outward, right, up;
  };
  static constexpr Face faces[] = {
      {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
      {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
  };
  const float sign = shape.side == Side::outside ? 1.0f : -1.0f;  // seen from inside, right is left
  Mesh mesh{.name = "box"};
  for (const Face& face : faces)
    add_grid(mesh, 1, 1, [&](int column, int row) {
      const glm::vec3 corner = face.outward + sign * float(2 * column - 1) * face.right + float(2 * row - 1) * face.up;
      return Vertex{0.5f * shape.size * corner, sign * face.outward, {float(column), float(row)}};
    });
  return mesh;
}

Mesh make_plane(const PlaneShape& shape) {
  require_length("plane", "width", shape.width);
  require_length("plane", "depth", shape.depth);
  require_count("plane", "columns", shape.columns, 1, 4096);
  require_count("plane", "rows", shape.rows, 1, 4096);
  require_repeat("plane", shape.repeat);
  Mesh mesh{.name = "plane"};
  add_grid(mesh, shape.columns, shape.rows, [&](int column, int row) {
    const float u = float(column) / float(shape.columns), v = float(row) / float(shape.rows);
    return Vertex{{(u - 0.5f) * shape.width, 0, (0.5f - v) * shape.depth}, {0, 1, 0}, glm::vec2(u, v) * shape.repeat};
  });
  return mesh;
}

Mesh make_cylinder_wall(const CylinderWallShape& shape) {
  require_length("cylinder wall", "radius", shape.radius);
  require_length("cylinder wall", "height", shape.height);
  require_count("cylinder wall", "segments", shape.segments, 3, most_segments);
  require_repeat("cylinder wall", shape.repeat);
  const int n = shape.segments;
  const bool inside = shape.side == Side::inside;
  Mesh mesh{.name = "cylinder wall"};
  add_grid(mesh, n, 1, [&](int column, int row) {
    const glm::dvec3 outward = around_y(inside ? n - column : column, n);
    const glm::dvec3 position = double(shape.radius) * outward + glm::dvec3(0, row * double(shape.height), 0);
    const glm::vec2 texcoord(float(column) / float(n), float(row));
    return Vertex{glm::vec3(position), glm::vec3(inside ? -outward : outward), texcoord * shape.repeat};
  });
  return mesh;
}

Mesh make_disc(const DiscShape& shape) {
  require_length("disc", "radius", shape.radius);
  require_count("disc", "segments", shape.segments, 3, most_segments);
  Mesh mesh{.name = "disc", .vertices = {{{0, 0, 0}, {0, 1, 0}, {0.5f, 0.5f}}}};
  for (int i = 0; i < shape.segments; ++i) {
    const glm::dvec3 p = around_y(i, shape.segments);
    const glm::vec2 texcoord(0.5 + 0.5 * p.x, 0.5 - 0.5 * p.z);
    mesh.vertices.push_back({glm::vec3(double(shape.radius) * p), {0, 1, 0}, texcoord});
  }
  for (int i = 0; i < shape.segments; ++i)
    mesh.indices.insert(mesh.indices.end(), {0u, std::uint32_t(1 + i), std::uint32_t(1 + (i + 1) % shape.segments)});
  return mesh;
}

namespace {

/// The bottom of a closed shape: a disc that faces -y.
Mesh floor_disc(float radius, int segments) {
  Mesh floor = make_disc({radius, segments});
  turn_inside_out(floor);
  for (Vertex& vertex : floor.vertices) vertex.texcoord.x = 1 - vertex.texcoord.x;  // not mirrored when seen from below
  return floor;
}

}  // namespace

Mesh make_cylinder(const CylinderShape& shape) {
  Mesh mesh = make_cylinder_wall({shape.radius, shape.height, shape.segments});
  mesh.name = "cylinder";
  Mesh lid = make_disc({shape.radius, shape.segments});
  for (Vertex& vertex : lid.vertices) vertex.position.y = shape.height;
  append(mesh, lid);
  append(mesh, floor_disc(shape.radius, shape.segments));
  return mesh;
}

Mesh make_cone(const ConeShape& shape) {
  require_length("cone", "radius", shape.radius);
  require_length("cone", "height", shape.height);
  require_count("cone", "segments", shape.segments, 3, most_segments / 2);
  const int n = shape.segments;
  // The slope is -height / radius, so the normal's is radius / height.
  const auto normal = [&](const glm::dvec3& outward) {
    return glm::vec3(glm::normalize(double(shape.height) * outward + glm::dvec3(0, shape.radius, 0)));
  };
  Mesh mesh{.name = "cone"};
  add_grid(mesh, n, 1, [&](int column, int row) {
    const float u = float(column) / float(n);
    if (row == 0) {
      const glm::dvec3 outward = around_y(column, n);
      return Vertex{glm::vec3(double(shape.radius) * outward), normal(outward), {u, 0}};
    }
    const float middle = std::max(0.0f, u - 0.5f / float(n));  // of the tip of the triangle to the left of this column
    return Vertex{{0, shape.height, 0}, normal(around_y(2 * column - 1 + 2 * n, 2 * n)), {middle, 1}};
  });
  append(mesh, floor_disc(shape.radius, n));
  return mesh;
}

}  // namespace atelier
