// Rays through portals and mirrors.
#include "catch.hpp"
#include "pieces.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

/// A square of 2 m a side in the plane z = 0, facing +z.
Mesh opening_square() {
  const auto corner = [](float x, float y) { return Vertex{{x, y, 0}, {0, 0, 1}, {(x + 1) / 2, (y + 1) / 2}}; };
  return {.name = "square",
          .vertices = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)},
          .indices = {0, 1, 2, 0, 2, 3}};
}

/// A square that stands at `at` and faces +z, turned about y by so many degrees. Returns its node.
int add_square(Scene& scene, const char* name, const glm::dvec3& at, double turn) {
  return add_node(scene, {.name = name, .translation = at, .rotation_angle = degrees(turn), .mesh = 0});
}

/// An opening at the origin that leads to one at (20, 0, 5), turned by a quarter to face +x; 4 m before that, a square
/// that faces it, and 1 m behind it one that must not be seen. A third square stands 3 m behind the opening at the
/// origin.
Scene two_places() {
  Scene scene = dark_scene();
  scene.background = {0.25f, 0.5f, 0.75f};
  add_mesh(scene, opening_square());
  const int here = add_square(scene, "here", {0, 0, 0}, 0);
  const int there = add_square(scene, "there", {20, 0, 5}, 90);
  add_square(scene, "seen", {24, 0, 5}, -90);
  add_square(scene, "before the exit", {19, 0, 5}, 90);
  add_square(scene, "behind", {0, 0, -3}, 0);
  scene.portals = {{.node = here, .exit = there, .colour = {1, 0, 0.5f}}, {.node = there, .exit = here}};
  scene.camera = {.eye = {0, 0, 2}, .target = {0, 0, 0}, .fov_y = degrees(20), .near = 0.1f, .far = 100};
  return scene;
}

Image traced(const Scene& scene, oracle::Output output, int depth) {
  const oracle::World world(scene);
  oracle::PictureRequest request{.camera = scene.camera, .size = {9, 9}, .output = output, .threads = 1};
  request.shading.portal_depth = depth;
  return oracle::trace(world, request);
}

Rgba middle(const Scene& scene, oracle::Output output, int depth) {
  return traced(scene, output, depth).at(4, 4);
}

}  // namespace

TEST_CASE("a ray goes through a portal to what stands before the exit", "[portal]") {
  const Scene scene = two_places();
  const Rgba thing = middle(scene, oracle::Output::thing, 1);
  CHECK(thing.r == 3);  // the node "seen", plus one
  const Rgba position = middle(scene, oracle::Output::position, 1);
  CHECK(position.r == Approx(24));
  CHECK(std::abs(position.g) < 1e-6);
  CHECK(position.b == Approx(5));
  // 2 m to the opening and 4 m behind it: the depth is that of 6 m.
  const double near = scene.camera.near, far = scene.camera.far, z = 6;
  CHECK(middle(scene, oracle::Output::depth, 1).r == Approx((1 / near - 1 / z) / (1 / near - 1 / far)));
}

TEST_CASE("an opening that is too deep shows its colour, in colour alone", "[portal]") {
  const Scene scene = two_places();
  const Rgba colour = middle(scene, oracle::Output::colour, 0);
  CHECK((colour.r == 1 && colour.g == 0 && colour.b == 0.5f));
  CHECK(middle(scene, oracle::Output::position, 0).r == 0);
}

TEST_CASE("an opening before the near plane is seen through too", "[portal]") {
  Scene scene = two_places();
  scene.camera.eye = {0, 0, 0.01};
  scene.camera.target = {0, 0, -1};
  CHECK(middle(scene, oracle::Output::thing, 1).r == 3);
  CHECK(middle(scene, oracle::Output::thing, 0).r == 0);
}

TEST_CASE("an opening behind another is seen through too, both before the near plane", "[portal]") {
  // 0.01 m to the first opening; 0.03 m behind its exit stands a second one, whose exit is at (0, 0, 50).
  Scene scene = two_places();
  scene.camera.eye = {0, 0, 0.01};
  scene.camera.target = {0, 0, -1};
  const int second = add_square(scene, "second", {20.03, 0, 5}, -90);
  const int far = add_node(scene, {.name = "far", .translation = {0, 0, 50}});
  const int seen_far = add_square(scene, "seen far", {0, 0, 54}, 180);
  scene.portals.push_back({.node = second, .exit = far});
  CHECK(middle(scene, oracle::Output::thing, 2).r == float(seen_far + 1));
  CHECK(middle(scene, oracle::Output::thing, 1).r == 0);
  // A surface in its place is cut off.
  scene.portals.pop_back();
  CHECK(middle(scene, oracle::Output::thing, 2).r == 3);
}

TEST_CASE("a two-sided portal is open from both sides, near and far from the origin", "[portal]") {
  struct Row {
    const char* name;
    bool two_sided, from_behind;
    int thing;  ///< as Output::thing counts: from 1
  };
  const Row rows[] = {{"one-sided, from the front", false, false, 3},
                      {"one-sided, from behind", false, true, 0},
                      {"two-sided, from the front", true, false, 3},
                      {"two-sided, from behind", true, true, 4}};
  // Positions of a million metres are rounded to 1e-10 m: the place of the exit's opening is no more exact.
  for (const glm::dvec3& offset : {glm::dvec3(0), glm::dvec3(1e6 + 0.3, -0.7, 1e6)})
    for (const double distance : {2.0, 1e-6})
      for (const Row& row : rows) {
        INFO(row.name << ", " << distance << " m before it, " << offset.x << " m from the origin");
        Scene scene = two_places();
        for (Node& node : scene.nodes) node.translation += offset;
        const int opening = add_material(scene, {.name = "opening", .two_sided = row.two_sided});
        for (const Portal& portal : scene.portals) scene.nodes[std::size_t(portal.node)].material = opening;
        const double side = row.from_behind ? -1 : 1;
        scene.camera.eye = offset + glm::dvec3(0, 0, side * distance);
        scene.camera.target = scene.camera.eye - glm::dvec3(0, 0, side);
        const Image things = traced(scene, oracle::Output::thing, 4);
        int others = 0;
        for (const Rgba& p : things.pixels()) others += p.r != float(row.thing);
        CHECK(others == 0);
      }
}

TEST_CASE("a depth of portals out of range is refused", "[portal]") {
  const auto words = [](int depth) { return error_of([&] { middle(two_places(), oracle::Output::thing, depth); }); };
  CHECK(words(0).empty());
  CHECK(words(255).empty());
  CHECK(mentions(words(-1), {"-1 portals", "0 to 255"}));
  CHECK(mentions(words(256), {"256 portals", "0 to 255"}));
}

TEST_CASE("a mirror shows what stands before it, the other way round", "[portal]") {
  Scene scene = two_places();
  scene.portals = {{.node = 0}};
  add_square(scene, "facing the mirror", {1.5, 0, 4}, 180);
  // The eye at (0.5, 2) in x and z looks at the mirror's point (0.875, 0). Reflected, the ray meets the square at z
  // = 4.
  scene.camera.eye = {0.5, 0, 2};
  scene.camera.target = {0.875, 0, 0};
  const Rgba position = middle(scene, oracle::Output::position, 1);
  CHECK(position.r == Approx(0.5 + 0.375 * 3));  // 6 m of way, 0.375 m sideways for every 2 m
  CHECK(position.b == Approx(4));
}

TEST_CASE("a two-sided mirror reflects on its back too", "[portal]") {
  Scene scene = two_places();
  scene.portals = {{.node = 0}};
  scene.nodes[0].material = add_material(scene, {.name = "glass", .two_sided = true});
  scene.camera.eye.z = -2;
  CHECK(middle(scene, oracle::Output::thing, 1).r == 5);  // 2 m to the mirror, and back past the eye to "behind"
  CHECK(middle(scene, oracle::Output::position, 1).b == Approx(-3));
}

TEST_CASE("openings are found through walls, before an end that does not belong to them", "[portal]") {
  // From z = 2 to 0, through a wall at z = 1.
  Scene scene = two_places();
  scene.nodes[0].material = scene.nodes[1].material = add_material(scene, {.name = "opening", .two_sided = true});
  add_square(scene, "wall", {0, 0, 1}, 0);
  const oracle::World world(scene);
  const oracle::Portals portals(scene);
  const oracle::Segment way{.ray = {.origin = {0, 0, 2}, .direction = {0, 0, -2}}};
  CHECK_FALSE(first_opening(world, portals, way, 1));
  const auto met = first_opening(world, portals, way, 1.5);
  REQUIRE(met);
  CHECK(met->t == 1);
  CHECK(met->thing == 0);
  // Who starts on the plane goes through, and then meets neither that opening nor the one at the exit.
  const oracle::Segment from_plane{.ray = {.origin = {0, 0, 0}, .direction = {0, 0, -2}}};
  const auto at_once = first_opening(world, portals, from_plane, 1);
  REQUIRE(at_once);
  CHECK(at_once->t == 0);
  const oracle::Segment rest = beyond(*portals.at(*at_once), from_plane, 0);
  CHECK_FALSE(first_opening(world, portals, rest, 100));
}
