// Intersections of rays and triangles: position, side, and no gaps between triangles.
#include "catch.hpp"
#include "pieces.hpp"

namespace atelier::test {
namespace {

using oracle::intersect;
using oracle::Ray;
using oracle::ShearedRay;

const glm::dvec3 a{0, 0, 0}, b{2, 0, 0}, c{0, 2, 0};  // counter-clockwise seen from +z

/// Every corner, and points along every edge, of a mesh around the origin.
std::vector<glm::dvec3> seams(const Mesh& mesh) {
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 from(mesh.vertices[mesh.indices[i + std::size_t(k)]].position),
          to(mesh.vertices[mesh.indices[i + std::size_t((k + 1) % 3)]].position);
      for (const double share : {0.0, 0.5, 1.0 / 3, 0.123456789}) points.push_back(from + share * (to - from));
    }
  return points;
}

}  // namespace

TEST_CASE("a triangle is hit inside, on its edges and at its corners, from both sides", "[triangle]") {
  const struct {
    const char* name;
    glm::dvec3 origin, direction;
    bool met, front;
    double t, weight_b, weight_c;
  } rows[] = {
      {"inside, from the front", {0.5, 0.5, 3}, {0, 0, -1}, true, true, 3, 0.25, 0.25},
      {"the same with a longer direction", {0.5, 0.5, 3}, {0, 0, -4}, true, true, 0.75, 0.25, 0.25},
      {"inside, from behind", {0.5, 0.5, -3}, {0, 0, 1}, true, false, 3, 0.25, 0.25},
      {"at a slant", {-0.5, 0.5, 1}, {1, 0, -1}, true, true, 1, 0.25, 0.25},
      {"on an edge", {1, 1, 1}, {0, 0, -1}, true, true, 1, 0.5, 0.5},
      {"on a corner", {2, 0, 1}, {0, 0, -1}, true, true, 1, 1, 0},
      {"beside it", {1.1, 1.1, 1}, {0, 0, -1}, false, true, 0, 0, 0},
      {"behind the ray", {0.5, 0.5, -1}, {0, 0, -1}, false, true, 0, 0, 0},
      {"along its plane", {-1, 0.5, 0}, {1, 0, 0}, false, true, 0, 0, 0},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const auto hit = intersect(ShearedRay({row.origin, row.direction}), a, b, c);
    CHECK(hit.has_value() == row.met);
    if (!hit || !row.met) continue;
    // A handful of roundings of numbers of size 1 to 4.
    CHECK(std::abs(hit->t - row.t) < 1e-15);
    CHECK(std::abs(hit->b - row.weight_b) < 1e-15);
    CHECK(std::abs(hit->c - row.weight_c) < 1e-15);
    CHECK(hit->front == row.front);
  }
}

TEST_CASE("only hits within the ray's interval count, including its ends", "[triangle]") {
  const auto met = [](double least, double most) {
    return intersect(ShearedRay({{0.5, 0.5, 2}, {0, 0, -1}, least, most}), a, b, c).has_value();
  };
  CHECK(met(0, 2));
  CHECK(met(2, 3));
  CHECK_FALSE(met(0, 1.999));
  CHECK_FALSE(met(2.001, 9));
  CHECK(met(-5, 5));
}

TEST_CASE("triangles without area are never hit", "[triangle]") {
  const ShearedRay ray({{0.5, 0, 1}, {0, 0, -1}});
  CHECK_FALSE(intersect(ray, a, b, b));
  CHECK_FALSE(intersect(ray, a, b, {1, 0, 0}));
  CHECK_FALSE(intersect(ray, a, a, a));
}

TEST_CASE("no ray leaves a closed mesh between its triangles", "[triangle]") {
  const struct {
    const char* name;
    Mesh mesh;
    glm::dvec3 inside;
  } rows[] = {
      {"box", make_box({}), {0.1, 0.2, -0.05}},
      {"sphere with needles at its poles", make_sphere({.segments = 48, .rings = 24}), {0.01, 0.02, 0.03}},
      {"icosphere", make_icosphere({.subdivisions = 2}), {0, 0, 0}},
      {"cone", make_cone({.segments = 64}), {0.05, 0.3, 0.02}},
  };
  for (const auto& row : rows)
    for (const glm::dvec3& offset : {glm::dvec3(0), glm::dvec3(1e6, -3e5, 7e5)}) {
      INFO(row.name << " at " << offset.x);
      Scene scene = dark_scene();
      scene.materials[0].two_sided = true;
      add_object(scene, row.mesh, 0, {.translation = offset});
      const oracle::World world(scene);
      int slipped = 0, shot = 0;
      Dice dice;
      for (const glm::dvec3& point : seams(row.mesh))
        for (int i = 0; i < 5; ++i) {
          const glm::dvec3 origin = row.inside + offset + 0.05 * dice.in_cube();
          ++shot;
          if (!world.seen({origin, point + offset - origin})) ++slipped;
        }
      CHECK(shot > 100);
      CHECK(slipped == 0);
    }
}

}  // namespace atelier::test
