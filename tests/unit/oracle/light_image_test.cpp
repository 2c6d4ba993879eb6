// Light through portals, and light that mirrors reflect.
#include "catch.hpp"
#include "oracle/shade.hpp"
#include "oracle/shadow.hpp"
#include "pieces.hpp"
#include "scene/shapes.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

/// A square of 2 m a side in the plane z = 0, facing +z.
Mesh opening() {
  const auto corner = [](float x, float y) { return Vertex{{x, y, 0}, {0, 0, 1}, {(x + 1) / 2, (y + 1) / 2}}; };
  return {.name = "square",
          .vertices = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)},
          .indices = {0, 1, 2, 0, 2, 3}};
}

/// A lamp 2 m before an opening at the origin, and a floor 1.5 m below. The opening leads to the frame "there"; where
/// this is the opening itself, turned round, whoever goes through goes straight on.
Scene lamp_before_opening(const Node& there) {
  Scene scene = dark_scene();
  scene.materials[0].diffuse = glm::vec3(1);
  const int square = add_mesh(scene, opening());
  const int here = add_node(scene, {.name = "here", .mesh = square});
  const int exit = add_node(scene, there);
  scene.portals = {{.node = here, .exit = exit}};
  add_object(scene, make_plane({.width = 30, .depth = 30}), 0, {.name = "floor", .translation = {0, -1.5, 0}});
  add_light(scene, {.position = {0, 1, 2}, .colour = glm::vec3(5)});
  return scene;
}

/// Half a turn, exactly: an angle in floats would tilt the exit by 1e-7.
const Node straight_on{.name = "there", .matrix = glm::mat4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1)};

oracle::SurfacePoint on_floor(double x, double z) {
  return {.position = {x, -1.5, z}, .normal = {0, 1, 0}, .flat_normal = {0, 1, 0}, .thing = 2};
}

double through(const oracle::World& world, const oracle::SurfacePoint& point) {
  return oracle::visibility(world, point, world.images().at(0), {.shadows = oracle::Shadows::hard});
}

}  // namespace

TEST_CASE("light goes through an opening and nowhere else", "[portal][light]") {
  const Scene scene = lamp_before_opening(straight_on);
  const oracle::World world(scene);
  REQUIRE(world.images().size() == 1);
  CHECK(glm::distance(world.images()[0].light.position, glm::dvec3(0, 1, 2)) < 1e-6);
  // From 2.5 m above the floor and 2 m before the plane, the lower rim (1 m below the middle) is seen to z = -0.5, and
  // at z = -z0 the sides to |x| = (z0 + 2) / 2.
  CHECK(through(world, on_floor(0, -0.45)) == 0);
  CHECK(through(world, on_floor(0, -0.55)) == 1);
  CHECK(through(world, on_floor(2.45, -3)) == 1);
  CHECK(through(world, on_floor(2.55, -3)) == 0);
  CHECK(through(world, on_floor(0, 1)) == 0);  // before the opening
}

TEST_CASE("the light through an opening that goes straight on is the light itself", "[portal][light]") {
  Scene with = lamp_before_opening(straight_on);
  add_object(with, make_box({.size = glm::vec3(0.3f)}), 0, {.name = "before", .translation = {0.5, 0.2, 0.6}});
  add_object(with, make_box({.size = glm::vec3(0.3f)}), 0, {.name = "behind", .translation = {-0.6, -0.6, -0.8}});
  Scene without = with;
  without.portals.clear();
  without.nodes[0].casts_shadow = false;
  const oracle::World there(with), here(without);
  int lit = 0, shaded = 0;
  for (double z = -0.6; z > -6; z -= 0.13)
    for (double x = -(2 - z) / 2 + 0.02; x < (2 - z) / 2; x += 0.11) {
      const oracle::SurfacePoint point = on_floor(x, z);
      const oracle::Shading hard{.shadows = oracle::Shadows::hard};
      const double straight = oracle::visibility(here, point, without.lights[0], hard);
      CHECK(through(there, point) == straight);
      (straight > 0 ? lit : shaded) += 1;
    }
  CHECK(lit > 500);
  CHECK(shaded > 50);
}

TEST_CASE("light comes out at an exit that stands elsewhere", "[portal][light]") {
  const Node there{.name = "there", .translation = {1e5, 0, 7}, .rotation_angle = degrees(90)};
  const Scene scene = lamp_before_opening(there);
  const oracle::World world(scene);
  REQUIRE(world.images().size() == 1);
  // The exit faces +x: what is 2 m before the entry is 2 m behind it.
  CHECK(glm::distance(world.images()[0].light.position, glm::dvec3(1e5 - 2, 1, 7)) < 1e-6);
  CHECK(through(world, on_floor(1e5 + 0.55, 7)) == 1);
  CHECK(through(world, on_floor(1e5 + 0.45, 7)) == 0);
  CHECK(through(world, on_floor(1e5 - 0.55, 7)) == 0);
}

TEST_CASE("only light on the open side enters", "[portal][light]") {
  Scene scene = lamp_before_opening(straight_on);
  scene.lights[0].position.z = -2;
  CHECK(oracle::light_images(scene).empty());
  scene.materials[0].two_sided = true;
  CHECK(oracle::light_images(scene).size() == 1);
  scene.materials[0].two_sided = false;
  scene.lights[0] = {.type = LightType::directional, .direction = {0, 0, -1}};
  CHECK(oracle::light_images(scene).size() == 1);
  scene.lights[0].direction = {0, 0, 1};
  CHECK(oracle::light_images(scene).empty());
}

TEST_CASE("a mirror throws light back", "[portal][light]") {
  Scene scene = lamp_before_opening(straight_on);
  scene.portals[0].exit.reset();
  const oracle::World world(scene);
  REQUIRE(world.images().size() == 1);
  CHECK(glm::distance(world.images()[0].light.position, glm::dvec3(0, 1, -2)) < 1e-12);
  CHECK(through(world, on_floor(0, 0.55)) == 1);
  CHECK(through(world, on_floor(0, 0.45)) == 0);
  // Its light is part of the picture if that is asked for: with the image's distance and cosine.
  const oracle::SurfacePoint point = on_floor(0, 1);
  const glm::dvec3 eye(0, 3, 1);
  oracle::Shading shading{.shadows = oracle::Shadows::hard};
  const double plain = oracle::shade(world, point, eye, shading).r;
  shading.portal_lights = true;
  const double with = oracle::shade(world, point, eye, shading).r;
  const double distance2 = 2.5 * 2.5 + 3.0 * 3.0, cosine = 2.5 / std::sqrt(distance2);
  CHECK(with - plain == Approx(5 * cosine / distance2));
}

TEST_CASE("a node ends at a plane", "[light]") {
  Scene scene = dark_scene();
  add_object(scene, make_sphere({.radius = 1}), 0, {.name = "half"});
  scene.nodes[0].kept = glm::dvec4(0.6, 0.8, 0, -0.1);
  Scene whole = scene;
  whole.nodes[0].kept.reset();
  const oracle::World cut(scene), full(whole);
  for (double x = -0.95; x < 1; x += 0.1)
    for (double y = -0.95; y < 1; y += 0.1) {
      const oracle::Ray ray{.origin = {x, y, 5}, .direction = {0, 0, -1}};
      const auto a = cut.seen(ray), b = full.seen(ray);
      const double side = 0.6 * x + 0.8 * y - 0.1;
      if (std::abs(side) < 1e-9) continue;
      REQUIRE(a.has_value() == (b.has_value() && side > 0));
      if (!a) continue;
      CHECK(a->t == Approx(b->t).epsilon(1e-12));
      CHECK(glm::distance(a->normal, b->normal) < 1e-6);
      CHECK(glm::distance(a->texcoord, b->texcoord) < 1e-6);
      CHECK(cut.blocked(ray));
    }
}

TEST_CASE("soft shadows of light through openings are refused", "[portal][light]") {
  CHECK_THROWS_AS(oracle::validate({.shadows = oracle::Shadows::soft, .light_width = 0.1, .portal_lights = true}),
                  Error);
}
