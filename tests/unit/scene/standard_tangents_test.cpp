#include "scene/standard_tangents.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "catch.hpp"
#include "scene/shapes.hpp"
#include "tangent_cases.hpp"

using namespace atelier;
using atelier::test::mirrored_strip;

namespace {

/// Meshes whose edges belong to at most two triangles each.
std::vector<Mesh> manifold_meshes() {
  return {make_sphere({.segments = 32, .rings = 16}),
          make_icosphere({.subdivisions = 3}),
          make_torus({.segments = 24, .sides = 12}),
          make_box(),
          make_cone({.segments = 20}),
          make_teapot({.subdivisions = 4}),
          mirrored_strip()};
}

/// The largest difference between two lists of tangents, as a distance between unit vectors; 2 if a sign differs.
double largest_difference(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, a[i].w == b[i].w ? double(glm::length(glm::vec3(a[i]) - glm::vec3(b[i]))) : 2);
  return largest;
}

/// The same triangles in the order of `order`, each starting with its corner number `turn`.
Mesh reordered(const Mesh& mesh, const std::vector<std::size_t>& order, int turn) {
  Mesh result = mesh;
  for (std::size_t t = 0; t < order.size(); ++t)
    for (int i = 0; i < 3; ++i) result.indices[3 * t + i] = mesh.indices[3 * order[t] + (i + turn) % 3];
  return result;
}

/// 0 .. count - 1, shuffled; the same in every run.
std::vector<std::size_t> shuffled(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::uint32_t random = 7;
  for (std::size_t i = count; i > 1; --i) {
    random = random * 1664525u + 1013904223u;  // a linear congruential generator (Numerical Recipes)
    std::swap(order[i - 1], order[(random >> 8) % i]);
  }
  return order;
}

Mesh split(const Mesh& mesh) {
  Mesh result;
  for (const std::uint32_t index : mesh.indices) {
    result.indices.push_back(std::uint32_t(result.vertices.size()));
    result.vertices.push_back(mesh.vertices[index]);
  }
  return result;
}

}  // namespace

TEST_CASE("tangents are those of another implementation of the standard", "[standard_tangents]") {
  for (const auto& [mesh, expected] : test::known_tangents()) {
    INFO(mesh.name);
    CHECK(largest_difference(standard_tangents(mesh), expected) < 1e-5);  // sums and roots of floats: 6e-8 each
  }
}

TEST_CASE("tangents are unit vectors perpendicular to the normals", "[standard_tangents]") {
  for (const Mesh& mesh : manifold_meshes()) {
    INFO(mesh.name);
    const std::vector<glm::vec4> tangents = standard_tangents(mesh);
    REQUIRE(tangents.size() == mesh.indices.size());
    for (std::size_t i = 0; i < tangents.size(); ++i) {
      const glm::vec3 t(tangents[i]), normal = mesh.vertices[mesh.indices[i]].normal;
      // Rounding of three floats. A mean of directions that partly cancel is less exactly perpendicular.
      if (!(std::abs(glm::length(t) - 1) < 1e-6f) || !(std::abs(glm::dot(t, normal)) < 1e-5f) ||
          std::abs(tangents[i].w) != 1)
        FAIL("corner " << i << ": " << t.x << " " << t.y << " " << t.z << " " << tangents[i].w);
    }
  }
}

TEST_CASE("neither order nor welding changes tangents", "[standard_tangents]") {
  for (const Mesh& mesh : manifold_meshes()) {
    INFO(mesh.name);
    const std::vector<glm::vec4> tangents = standard_tangents(mesh);
    CHECK(standard_tangents(split(mesh)) == tangents);

    const std::vector<std::size_t> order = shuffled(mesh.indices.size() / 3);
    for (const int turn : {0, 1, 2}) {
      std::vector<glm::vec4> expected = tangents;
      for (std::size_t t = 0; t < order.size(); ++t)
        for (int i = 0; i < 3; ++i) expected[3 * t + i] = tangents[3 * order[t] + (i + turn) % 3];
      // Other sums, and other differences of the same corners: those of texture coordinates are exact to 6e-8 of 1, of
      // steps of 1/32, so directions to 1e-5.
      CHECK(largest_difference(standard_tangents(reordered(mesh, order, turn)), expected) < 5e-5);
    }
  }
}

TEST_CASE("zeros of both signs are one place", "[standard_tangents]") {
  const Mesh mesh = mirrored_strip();
  Mesh other = split(mesh);
  for (std::size_t v = 0; v < other.vertices.size(); v += 2)
    for (int i = 0; i < 3; ++i)
      if (other.vertices[v].position[i] == 0) other.vertices[v].position[i] = -0.0f;
  CHECK(standard_tangents(other) == standard_tangents(mesh));
}

TEST_CASE("triangles with two corners at one place change nothing and take the tangents there", "[standard_tangents]") {
  for (const Mesh& mesh : manifold_meshes()) {
    INFO(mesh.name);
    const std::vector<glm::vec4> tangents = standard_tangents(mesh);
    Mesh more = mesh;
    more.indices.clear();
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
      const std::uint32_t *corner = &mesh.indices[t], *other = &mesh.indices[(t * 7) % mesh.indices.size()];
      more.indices.insert(more.indices.end(), {corner[0], corner[0], other[0], corner[0], corner[1], corner[2]});
    }
    const std::vector<glm::vec4> result = standard_tangents(more);
    std::vector<glm::vec4> kept;
    for (std::size_t t = 0; t < result.size(); t += 6)
      kept.insert(kept.end(), result.begin() + std::ptrdiff_t(t) + 3, result.begin() + std::ptrdiff_t(t) + 6);
    CHECK(kept == tangents);
    for (std::size_t i = 0; i < result.size(); ++i) {
      bool found = false;
      for (std::size_t c = 0; c < tangents.size() && !found; ++c)
        found = mesh.indices[c] == more.indices[i] && tangents[c] == result[i];
      if (!found) FAIL("corner " << i << " has a tangent that no triangle has at its vertex");
    }
  }
}

TEST_CASE("mirrored charts do not share tangents", "[standard_tangents]") {
  const Mesh mesh = mirrored_strip();
  const std::vector<glm::vec4> tangents = standard_tangents(mesh);
  for (std::size_t t = 0; t < tangents.size(); t += 3) {
    const auto x = [&](int i) { return mesh.vertices[mesh.indices[t + i]].position.x; };
    const float side = x(0) + x(1) + x(2) > 0 ? 1.0f : -1.0f;
    for (int i = 0; i < 3; ++i) {
      CHECK(tangents[t + i].w == side);
      CHECK(tangents[t + i].x * side > 0.7f);  // u grows away from the middle on both sides
    }
  }
}

TEST_CASE("tangents of round shapes run eastwards, across the seam and up to the poles", "[standard_tangents]") {
  for (const Mesh& mesh : {make_sphere({.segments = 32, .rings = 16}), make_torus({.segments = 32, .sides = 16})}) {
    INFO(mesh.name);
    const std::vector<glm::vec4> tangents = standard_tangents(mesh);
    for (std::size_t i = 0; i < tangents.size(); ++i) {
      const Vertex& v = mesh.vertices[mesh.indices[i]];
      const double turn = 2 * 3.14159265358979 * v.texcoord.x;
      const glm::dvec3 east(-std::sin(turn), 0, -std::cos(turn));
      // At the seam, and at a pole, triangles lie on one side only: half a segment, 5.6 degrees.
      CHECK(glm::dot(glm::dvec3(tangents[i]), east) > 0.99);
      CHECK(tangents[i].w == 1);
    }
  }
}

TEST_CASE("a mesh without an area has the standard's default tangents", "[standard_tangents]") {
  CHECK(standard_tangents({}).empty());
  Mesh mesh = mirrored_strip();
  const std::vector<glm::vec4> defaults(mesh.indices.size(), {1, 0, 0, -1});
  SECTION("in the texture") {
    for (Vertex& v : mesh.vertices) v.texcoord = {0.5f, 0.25f * v.texcoord.y};
    CHECK(standard_tangents(mesh) == defaults);
  }
  SECTION("in space") {
    for (Vertex& v : mesh.vertices) v.position = {1, 2, 3};
    CHECK(standard_tangents(mesh) == defaults);
  }
}

TEST_CASE("tangents are finite for lengths and textures of any size", "[standard_tangents]") {
  for (const float size : {1e-38f, 1e-30f, 1e-15f, 1e15f, 1e30f, 3e38f})
    for (const float repeat : {1e-30f, 1.0f, 1e30f}) {
      INFO(size << " m, " << repeat << " repetitions");
      Mesh mesh = make_sphere({.segments = 8, .rings = 4});
      for (Vertex& v : mesh.vertices) {
        v.position *= size;
        v.texcoord *= repeat;
      }
      for (const glm::vec4& t : standard_tangents(mesh)) CHECK(std::abs(glm::length(glm::vec3(t)) - 1) < 1e-6f);
    }
}

TEST_CASE("hundreds of thousands of triangles may share a vertex", "[standard_tangents]") {
  // Neither the depth of the call stack nor the time may grow with them; quadratic time would be minutes.
  Mesh mesh = make_disc({.segments = 65536});
  const std::vector<std::uint32_t> once = mesh.indices;
  for (int copy = 0; copy < 4; ++copy) mesh.indices.insert(mesh.indices.end(), once.begin(), once.end());
  REQUIRE(std::ranges::count(mesh.indices, once[0]) > 300'000);
  const std::vector<glm::vec4> tangents = standard_tangents(mesh);
  for (std::size_t i = 0; i < tangents.size(); i += 997) CHECK(tangents[i].x > 0.999f);
}
