// Analytic shapes against their equations, and against the triangles that approximate them.
#include "catch.hpp"
#include "pieces.hpp"

namespace atelier::test {
namespace {

using oracle::CylinderWall;
using oracle::Ray;
using oracle::Sphere;
using oracle::Surface;

/// How far a point is off the surface's equation, metres.
double off_surface(const Surface& surface, const glm::dvec3& p) {
  if (const auto* sphere = std::get_if<Sphere>(&surface)) return std::abs(glm::length(p) - sphere->radius);
  if (const auto* wall = std::get_if<CylinderWall>(&surface))
    return std::abs(glm::length(glm::dvec2(p.x, p.z)) - wall->radius);
  return std::abs(p.y);
}

}  // namespace

TEST_CASE("points of shapes satisfy their equations, with unit normals", "[shape]") {
  const struct {
    const char* name;
    Surface surface;
  } rows[] = {{"sphere", Sphere{1.5}},
              {"column", CylinderWall{0.8, 3}},
              {"hall", CylinderWall{0.8, 3, true}},
              {"rectangle", oracle::Rectangle{.half_u = {2, 0, 0}, .half_v = {0, 0, -1}}}};
  for (const auto& row : rows) {
    INFO(row.name);
    Dice dice;
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
      const Ray ray{3.0 * dice.in_cube(), dice.in_cube()};
      const auto hit = oracle::intersect(row.surface, ray, false);
      if (!hit) continue;
      ++met;
      // Quadratics lose digits where the ray grazes or t is large: up to 1e3 times the rounding of numbers near 10.
      CHECK(off_surface(row.surface, ray.at(hit->t)) < 1e-12);
      CHECK(std::abs(glm::length(hit->normal) - 1) < 1e-15);
      CHECK((hit->texcoord.x >= 0 && hit->texcoord.x <= 1 && hit->texcoord.y >= 0 && hit->texcoord.y <= 1));
      if (const auto front = oracle::intersect(row.surface, ray, true))
        CHECK(glm::dot(front->normal, ray.direction) < 0);
    }
    CHECK(met > 100);
  }
}

TEST_CASE("a wall is seen from the side that it faces", "[shape]") {
  const Ray through{{-5, 1, 0}, {1, 0, 0}};
  const auto column = oracle::intersect(CylinderWall{2, 3}, through, true);
  REQUIRE(column);
  CHECK(column->t == Approx(3));
  CHECK(column->normal == glm::dvec3(-1, 0, 0));
  const auto hall = oracle::intersect(CylinderWall{2, 3, true}, through, true);
  REQUIRE(hall);  // the near wall turns its back
  CHECK(hall->t == Approx(7));
  CHECK(hall->normal == glm::dvec3(-1, 0, 0));
  CHECK_FALSE(oracle::intersect(CylinderWall{2, 0.5}, through, true));
  const Ray aside{{0, 1, 0}, {0.6, 0, 0.8}};  // u is not 0 there
  const auto once = oracle::intersect(CylinderWall{2, 3, true}, aside, true),
             often = oracle::intersect(CylinderWall{2, 3, true, 10}, aside, true);
  REQUIRE((once && often));
  CHECK(once->texcoord.x > 0.1);
  CHECK(often->texcoord.x == Approx(10 * once->texcoord.x));
  CHECK(often->texcoord.y == once->texcoord.y);
}

TEST_CASE("a tessellated wall is inside the round one by the sagitta", "[shape]") {
  for (const Side side : {Side::outside, Side::inside})
    for (const int n : {3, 16, 64, 256}) {
      INFO(n << " segments");
      Scene scene = dark_scene();
      scene.materials[0].two_sided = true;
      add_object(scene, make_cylinder_wall({.radius = 2, .height = 1, .segments = n, .side = side}), 0);
      const oracle::World flat(scene);
      const Surface round = CylinderWall{2, 1, side == Side::inside};
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * pi * (i + 0.5) / n;  // the middle of a side
        const Ray ray{{0, 0.5, 0}, {std::cos(angle), 0, std::sin(angle)}};
        const auto seen = flat.seen(ray);
        const auto exact = oracle::intersect(round, ray, false);
        REQUIRE((seen && exact));
        CHECK(exact->t == Approx(2).epsilon(1e-14));
        // The mesh's corners are floats: 2^-24 of the radius.
        CHECK(std::abs(exact->t - seen->t - 2 * (1 - std::cos(pi / n))) < 2 * 0x1p-23);
        CHECK(glm::length(exact->texcoord - seen->texcoord) < 1e-6);
      }
    }
}

TEST_CASE("texture coordinates of a sphere are those of make_sphere", "[shape]") {
  Scene scene = dark_scene();
  add_object(scene, make_sphere({.radius = 1, .segments = 256, .rings = 128}), 0);
  const oracle::World world(scene, {});
  Dice dice;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 way = dice.in_cube();
    const Ray ray{glm::normalize(way) * 3.0, -way};
    const auto seen = world.seen(ray);
    const auto exact = oracle::intersect(Sphere{1}, ray, true);
    REQUIRE((seen && exact));
    // Within one of the 256 x 128 quads u and v differ by the bend of its sides alone, except around the poles.
    if (std::abs(exact->normal.y) < 0.9) CHECK(glm::length(exact->texcoord - seen->texcoord) < 1e-4);
  }
}

TEST_CASE("a shape is placed, turned and stretched by its matrix", "[shape]") {
  Scene scene = dark_scene();
  glm::dmat4 place(1);
  place[0][0] = 3;  // an ellipsoid, 3 m long, mirrored along z, at (10, 0, 0)
  place[2][2] = -1;
  place[3] = {10, 0, 0, 1};
  const oracle::World world(scene, {{.surface = Sphere{1}, .object_to_world = place}});
  const auto end = world.seen({{20, 0, 0}, {-1, 0, 0}});
  REQUIRE(end);
  CHECK(end->t == Approx(7));
  CHECK(glm::length(end->normal - glm::dvec3(1, 0, 0)) < 1e-15);
  // At object (sqrt 1/2, sqrt 1/2, 0) the ellipsoid x^2/9 + y^2 = 1 has the normal (x/9, y).
  const glm::dvec3 point(3 * std::sqrt(0.5), std::sqrt(0.5), 0), normal = glm::normalize(point / glm::dvec3(9, 1, 1));
  const auto side = world.seen({point + normal + glm::dvec3(10, 0, 0), -normal});
  REQUIRE(side);
  CHECK(side->t == Approx(1).epsilon(1e-12));
  CHECK(glm::length(side->normal - normal) < 1e-12);

  CHECK_THROWS_AS(oracle::World(scene, {{.surface = Sphere{1}, .object_to_world = glm::dmat4(0)}}), Error);
  CHECK_THROWS_AS(oracle::World(scene, {{.surface = Sphere{1}, .material = 1}}), Error);
}

}  // namespace atelier::test
