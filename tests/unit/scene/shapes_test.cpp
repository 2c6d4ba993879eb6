#include <functional>
#include <numbers>

#include "base/error.hpp"
#include "catch.hpp"
#include "mesh_facts.hpp"
#include "scene/shapes.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::measure;

namespace {

constexpr double pi = std::numbers::pi;
constexpr int open_mesh = -1;

struct Shape {
  const char* name;
  Mesh mesh;
  int euler;                // 2 for a sphere-like surface, 0 for a ring, open_mesh where there is a border
  double volume;            // m^3 of the smooth body; 0: none to compare with
  double volume_tolerance;  // relative: what flat facets take away, 2 pi^2 / (3 n^2) for an n-gon
  float agreement;          // least cosine between vertex normals and their triangles
  glm::vec2 high_texcoord{1, 1};
};

std::vector<Shape> shapes() {
  return {
      {"sphere", make_sphere(), 2, 4 * pi / 3, 0.01, 0.98f},
      {"coarsest sphere", make_sphere({.radius = 2, .segments = 3, .rings = 2}), 2, 0, 0, 0.4f},
      {"fine sphere", make_sphere({.radius = 0.5f, .segments = 256, .rings = 128}), 2, pi / 6, 0.001, 0.999f},
      {"tiny sphere", make_sphere({.radius = 1e-6f}), 2, 0, 0, 0.98f},
      {"huge sphere", make_sphere({.radius = 1e6f}), 2, 0, 0, 0.98f},
      {"icosahedron", make_icosphere({.subdivisions = 0}), 2, 0, 0, 0.79f, {1.5f, 1}},
      {"icosphere", make_icosphere({.subdivisions = 4}), 2, 4 * pi / 3, 0.005, 0.99f, {1.5f, 1}},
      {"torus", make_torus(), 0, 2 * pi * pi * 0.75 * 0.0625, 0.01, 0.98f},
      {"coarsest torus", make_torus({.segments = 3, .sides = 3}), 0, 0, 0, 0.2f},
      {"box", make_box({.size = {1, 2, 3}}), 2, 6, 1e-6, 0.999f},
      {"room", make_box({.size = {1, 2, 3}, .side = Side::inside}), 2, -6, 1e-6, 0.999f},
      {"plane", make_plane({.width = 2, .depth = 3, .repeat = {4, 5}}), open_mesh, 0, 0, 0.999f, {4, 5}},
      {"fine plane", make_plane({.columns = 7, .rows = 5}), open_mesh, 0, 0, 0.999f},
      {"wall from outside", make_cylinder_wall(), open_mesh, 0, 0, 0.99f},
      {"wall from inside", make_cylinder_wall({.side = Side::inside}), open_mesh, 0, 0, 0.99f},
      {"triangular wall", make_cylinder_wall({.segments = 3}), open_mesh, 0, 0, 0.49f},
      {"disc", make_disc(), open_mesh, 0, 0, 0.999f},
      {"cylinder", make_cylinder({.radius = 2, .height = 3}), 2, 12 * pi, 0.01, 0.99f},
      {"coarsest cylinder", make_cylinder({.segments = 3}), 2, 0, 0, 0.49f},
      {"cone", make_cone({.radius = 2, .height = 3}), 2, 4 * pi, 0.01, 0.99f},
      {"coarsest cone", make_cone({.segments = 3}), 2, 0, 0, 0.6f},
      // The spout's lip turns over within one patch: its coarse triangles stray far from the surface's own normals.
      {"teapot", make_teapot(), open_mesh, 0, 0, 0.35f},
      {"coarsest teapot", make_teapot({.subdivisions = 2}), open_mesh, 0, 0, -0.65f},
      {"fine teapot", make_teapot({.subdivisions = 32}), open_mesh, 0, 0, 0.9f},
  };
}

}  // namespace

TEST_CASE("every shape is a valid mesh", "[scene]") {
  for (const Shape& row : shapes()) {
    INFO(row.name);
    Scene scene{.name = row.name, .meshes = {row.mesh}};
    CHECK_NOTHROW(validate(scene));  // indices in range, all finite
    const auto facts = measure(row.mesh);
    CHECK(facts.finite);
    CHECK(facts.normal_length_error < 1e-6);  // rounding of three floats: 1.5 * 2^-24 each
    CHECK(facts.least_area > 0);
    CHECK(facts.least_agreement >= row.agreement);
    CHECK(facts.low_texcoord.x >= 0);
    CHECK(facts.low_texcoord.y >= 0);
    CHECK(facts.high_texcoord.x <= row.high_texcoord.x);
    CHECK(facts.high_texcoord.y <= row.high_texcoord.y);
    CHECK(facts.mirrored == 0);
    CHECK(facts.closed == (row.euler != open_mesh));
    if (row.euler != open_mesh) CHECK(facts.euler == row.euler);
    if (row.volume != 0) CHECK(facts.volume == Approx(row.volume).epsilon(row.volume_tolerance));
  }
}

TEST_CASE("shapes refuse invalid dimensions, and name them", "[scene]") {
  struct Bad {
    const char* name;
    std::function<Mesh()> make;
    const char* part;  // of the message
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Bad table[] = {
      {"two meridians", [] { return make_sphere({.segments = 2}); }, "sphere: segments 2 (allowed: 3..4096)"},
      {"one ring", [] { return make_sphere({.rings = 1}); }, "rings 1"},
      {"no radius", [] { return make_sphere({.radius = 0}); }, "radius 0 m"},
      {"negative radius", [] { return make_torus({.ring_radius = -1}); }, "ring_radius -1"},
      {"radius not a number", [=] { return make_disc({.radius = nan}); }, "radius nan"},
      {"endless radius", [] { return make_cone({.radius = INFINITY}); }, "radius inf"},
      {"tube as wide as its ring", [] { return make_torus({.ring_radius = 1, .tube_radius = 1}); }, "tube_radius 1"},
      {"flat box",
       [] {
         return make_box({.size = {1, 0, 1}});
       },
       "size.y 0"},
      {"too many columns", [] { return make_plane({.columns = 5000}); }, "columns 5000"},
      {"no repeat",
       [] {
         return make_plane({.repeat = {0, 1}});
       },
       "repeat 0"},
      {"two sides", [] { return make_cylinder_wall({.segments = 2}); }, "segments 2 (allowed: 3..65536)"},
      {"no height", [] { return make_cylinder({.height = 0}); }, "height 0"},
      {"teapot of no quads", [] { return make_teapot({.subdivisions = 0}); }, "subdivisions 0 (allowed: 2..64)"},
      {"endless icosphere", [] { return make_icosphere({.subdivisions = 9}); }, "subdivisions 9"},
  };
  for (const Bad& bad : table) {
    INFO(bad.name);
    CHECK(error_of(bad.make).find(bad.part) != std::string::npos);
  }
}

TEST_CASE("a cylinder wall lies on its circle and misses it by the sagitta", "[scene]") {
  for (const int n : {3, 16, 64, 256, 65536}) {
    INFO(n);
    const Mesh wall = make_cylinder_wall({.radius = 5, .height = 2, .segments = n});
    double nearest = 1e9, farthest = 0;
    for (std::size_t t = 0; t < wall.indices.size(); t += 3)
      for (int i = 0; i < 3; ++i) {
        const glm::dvec3 a = wall.vertices[wall.indices[t + i]].position;
        const glm::dvec3 b = wall.vertices[wall.indices[t + (i + 1) % 3]].position;
        const glm::dvec3 middle = (a + b) / 2.0;
        nearest = std::min(nearest, std::hypot(middle.x, middle.z));
        farthest = std::max(farthest, std::hypot(a.x, a.z));
      }
    CHECK(farthest == Approx(5).epsilon(1e-7));                             // half a float ulp of 5
    CHECK(5 - nearest == Approx(5 * (1 - std::cos(pi / n))).margin(1e-6));  // two float ulps of 5
  }
}

TEST_CASE("round shapes map their texture from +x eastwards, south to north", "[scene]") {
  const std::pair<const char*, Mesh> table[] = {
      {"sphere", make_sphere({.radius = 2})},
      {"icosphere", make_icosphere({.radius = 2, .subdivisions = 3})},
      {"torus", make_torus()},
      {"wall", make_cylinder_wall({.radius = 3})},
  };
  for (const auto& [name, mesh] : table) {
    INFO(name);
    for (const Vertex& v : mesh.vertices) {
      const glm::dvec3 p(v.position);
      const double away = std::hypot(p.x, p.z), turn = 2 * pi * v.texcoord.x;
      if (away < 1e-3) continue;  // a pole has no longitude
      // 1e-5: texture coordinates are floats, 6e-8 of a whole turn, and positions too.
      CHECK(std::abs(p.x / away - std::cos(turn)) < 1e-5);
      CHECK(std::abs(-p.z / away - std::sin(turn)) < 1e-5);
      if (mesh.name == "sphere" || mesh.name == "icosphere") CHECK((v.texcoord.y > 0.5f) == (p.y > 1e-6));
    }
  }
}

namespace {

/// How the first surface that a ray meets is turned: +1 to the ray's origin, -1 away from it, 0 where it meets none.
int first_hit(const Mesh& mesh, const glm::dvec3& origin, const glm::dvec3& direction) {
  double nearest = 1e300;
  int side = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const glm::dvec3 a = mesh.vertices[mesh.indices[t]].position;
    const glm::dvec3 e = glm::dvec3(mesh.vertices[mesh.indices[t + 1]].position) - a;
    const glm::dvec3 f = glm::dvec3(mesh.vertices[mesh.indices[t + 2]].position) - a;
    // Moller and Trumbore, "Fast, minimum storage ray-triangle intersection", 1997.
    const glm::dvec3 p = glm::cross(direction, f);
    const double determinant = glm::dot(e, p);
    if (determinant == 0) continue;
    const glm::dvec3 s = (origin - a) / determinant;
    const double u = glm::dot(s, p);
    const glm::dvec3 q = glm::cross(s, e);
    const double v = glm::dot(direction, q), distance = glm::dot(f, q);
    if (u < 0 || v < 0 || u + v > 1 || distance <= 0 || distance >= nearest) continue;
    nearest = distance;
    side = determinant > 0 ? 1 : -1;
  }
  return side;
}

}  // namespace

TEST_CASE("the teapot shows its outside from everywhere", "[scene]") {
  const Mesh teapot = make_teapot({.subdivisions = 6});
  int front = 0, back = 0;
  for (int azimuth = 0; azimuth < 8; ++azimuth)
    for (const double height : {0.3, 1.5}) {  // never down into the spout or through the gap of the lid
      const double turn = 2 * pi * (azimuth + 0.3) / 8;
      const glm::dvec3 eye(4 * std::cos(turn), height, 4 * std::sin(turn));
      for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 12; ++j) {
          const glm::dvec3 target(-1.0 + 0.17 * i, 0.03 + 0.08 * j, 0.013 * (i - 6) * (j - 5));
          const int side = first_hit(teapot, eye, target - eye);
          front += side > 0;
          back += side < 0;
        }
    }
  CHECK(front > 1000);
  // The mouth of the spout (an eightieth of the picture) and the slit under the lid let a few rays in.
  CHECK(back < front / 50);
}

TEST_CASE("the teapot has Newell's dimensions", "[scene]") {
  const Mesh teapot = make_teapot({.height = 3.15f});  // the data's own unit
  const Box3 box = box_around(teapot);
  CHECK(teapot.vertices.size() == 32 * 11 * 11);
  CHECK(box.low.y == Approx(0).margin(1e-6));
  CHECK(box.high.y == Approx(3.15).epsilon(1e-6));
  CHECK(box.low.x == Approx(-3.0).margin(0.01));    // the handle's outside, touched between two of its points
  CHECK(box.high.x == Approx(3.434).margin(0.01));  // the spout's lip, inside its control point at 3.525
  CHECK(box.high.z == Approx(2.0).margin(0.01));    // the belly
  CHECK(box.low.z == Approx(-box.high.z).margin(1e-6));
}
