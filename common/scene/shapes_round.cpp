// Sphere, icosphere and torus, with normals from their formulas.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "base/error.hpp"
#include "scene/shape_detail.hpp"
#include "scene/shapes.hpp"

namespace atelier {

using namespace shape_detail;

namespace {

/// The direction at `turn` (cosine and sine of the longitude, counter-clockwise from +x seen from above) and `rise`
/// (cosine and sine of the latitude).
glm::dvec3 direction(const glm::dvec2& turn, const glm::dvec2& rise) {
  return {rise.x * turn.x, rise.y, -rise.x * turn.y};
}

}  // namespace

Mesh make_sphere(const SphereShape& shape) {
  require_length("sphere", "radius", shape.radius);
  require_count("sphere", "segments", shape.segments, 3, 4096);
  require_count("sphere", "rings", shape.rings, 2, 4096);
  Mesh mesh{.name = "sphere"};
  add_grid(mesh, shape.segments, shape.rings, [&](int column, int row) {
    // A half circle from the south pole to the north pole; all vertices at a pole have exactly the same position.
    const bool south = row == 0, north = row == shape.rings;
    const glm::dvec2 half = circle_point(row, 2 * shape.rings);  // angle from the south pole
    const glm::dvec2 rise = south || north ? glm::dvec2(0, north ? 1 : -1) : glm::dvec2(half.y, -half.x);
    const glm::dvec3 n = direction(circle_point(column, shape.segments), rise);
    // At a pole each column has one triangle; its tip's u is the middle of the column.
    const double middle = south ? 0.5 : north ? -0.5 : 0.0;
    const double u = std::clamp((column + middle) / shape.segments, 0.0, 1.0);
    return Vertex{glm::vec3(double(shape.radius) * n), glm::vec3(n), {float(u), float(row) / float(shape.rings)}};
  });
  return mesh;
}

Mesh make_torus(const TorusShape& shape) {
  require_length("torus", "ring_radius", shape.ring_radius);
  require_length("torus", "tube_radius", shape.tube_radius);
  require_count("torus", "segments", shape.segments, 3, 4096);
  require_count("torus", "sides", shape.sides, 3, 4096);
  if (shape.tube_radius >= shape.ring_radius)
    throw Error(fmt::format("torus: tube_radius {} m (allowed: below the ring_radius of {} m)", shape.tube_radius,
                            shape.ring_radius));
  Mesh mesh{.name = "torus"};
  add_grid(mesh, shape.segments, shape.sides, [&](int column, int row) {
    const glm::dvec2 turn = circle_point(column, shape.segments), tube = circle_point(row, shape.sides);
    const glm::dvec3 n = direction(turn, tube);
    const glm::dvec3 middle = double(shape.ring_radius) * direction(turn, {1, 0});
    return Vertex{glm::vec3(middle + double(shape.tube_radius) * n),
                  glm::vec3(n),
                  {float(column) / float(shape.segments), float(row) / float(shape.sides)}};
  });
  return mesh;
}

namespace {

/// Directions and the triangles over them.
struct Geodesic {
  std::vector<glm::dvec3> directions;
  std::vector<std::array<int, 3>> faces;
};

/// The regular icosahedron: its vertices are the corners of three golden rectangles, one in each coordinate plane.
Geodesic icosahedron() {
  constexpr double g = std::numbers::phi;
  Geodesic solid{{{-1, g, 0},
                  {1, g, 0},
                  {-1, -g, 0},
                  {1, -g, 0},
                  {0, -1, g},
                  {0, 1, g},
                  {0, -1, -g},
                  {0, 1, -g},
                  {g, 0, -1},
                  {g, 0, 1},
                  {-g, 0, -1},
                  {-g, 0, 1}},
                 {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                  {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                  {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (glm::dvec3& d : solid.directions) d = glm::normalize(d);
  return solid;
}

/// Splits every face into four at the midpoints of its edges.
Geodesic subdivide(const Geodesic& coarse) {
  Geodesic fine{coarse.directions, {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [place, added] = middles.try_emplace(std::minmax(a, b), int(fine.directions.size()));
    if (added) fine.directions.push_back(glm::normalize(coarse.directions[a] + coarse.directions[b]));
    return place->second;
  };
  for (const auto& [a, b, c] : coarse.faces) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.faces.insert(fine.faces.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return fine;
}

bool is_pole(const glm::dvec3& d) {
  return d.x == 0 && d.z == 0;
}

/// Longitudes 0..1 of a face's corners, with 1 added to some if the face crosses the seam; a pole, which has no
/// longitude, gets the mean of the other two.
std::array<float, 3> longitudes(const std::array<glm::dvec3, 3>& corners) {
  std::array<double, 3> u;
  for (int i = 0; i < 3; ++i) {
    u[i] = std::atan2(-corners[i].z, corners[i].x) / (2 * std::numbers::pi);
    if (u[i] < 0) u[i] += 1;
  }
  for (int i = 0; i < 3; ++i)
    if (is_pole(corners[i])) u[i] = u[(i + 1) % 3];
  const double highest = std::max({u[0], u[1], u[2]});
  for (double& x : u)
    if (highest - x > 0.5) x += 1;
  for (int i = 0; i < 3; ++i)
    if (is_pole(corners[i])) u[i] = (u[(i + 1) % 3] + u[(i + 2) % 3]) / 2;
  return {float(u[0]), float(u[1]), float(u[2])};
}

}  // namespace

Mesh make_icosphere(const IcosphereShape& shape) {
  require_length("icosphere", "radius", shape.radius);
  require_count("icosphere", "subdivisions", shape.subdivisions, 0, 8);
  Geodesic solid = icosahedron();
  for (int i = 0; i < shape.subdivisions; ++i) solid = subdivide(solid);

  // Corners share a vertex where they share direction and longitude.
  Mesh mesh{.name = "icosphere"};
  std::map<std::pair<int, float>, std::uint32_t> vertices;
  for (const auto& face : solid.faces) {
    const auto u = longitudes({solid.directions[face[0]], solid.directions[face[1]], solid.directions[face[2]]});
    for (int i = 0; i < 3; ++i) {
      const auto [place, added] = vertices.try_emplace({face[i], u[i]}, std::uint32_t(mesh.vertices.size()));
      if (added) {
        const glm::dvec3& n = solid.directions[face[i]];
        const double v = 0.5 + std::asin(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
        mesh.vertices.push_back({glm::vec3(double(shape.radius) * n), glm::vec3(n), {u[i], float(v)}});
      }
      mesh.indices.push_back(place->second);
    }
  }
  return mesh;
}

}  // namespace atelier
