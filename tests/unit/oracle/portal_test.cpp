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

/// An opening at the origin that leads to one at (20, 0, 5), turned by a quarter to face +x; 4 m before that, a square
/// that faces it, and 1 m behind it one that must not be seen. A third square stands 3 m behind the opening at the
/// origin.
Scene two_places() {
  Scene scene = dark_scene();
  scene.background = {0.25f, 0.5f, 0.75f};
  const int mesh = add_mesh(scene, opening_square());
  const auto place = [&](const char* name, const glm::dvec3& at, float turn) {
    return add_node(scene, {.name = name, .translation = at, .rotation_angle = degrees(turn), .mesh = mesh});
  };
  const int here = place("here", {0, 0, 0}, 0);
  const int there = place("there", {20, 0, 5}, 90);
  place("seen", {24, 0, 5}, -90);
  place("before the exit", {19, 0, 5}, 90);
  place("behind", {0, 0, -3}, 0);
  scene.portals = {{.node = here, .exit = there, .colour = {1, 0, 0.5f}}, {.node = there, .exit = here}};
  scene.camera = {.eye = {0, 0, 2}, .target = {0, 0, 0}, .fov_y = degrees(20), .near = 0.1f, .far = 100};
  return scene;
}

Rgba middle(const Scene& scene, oracle::Output output, int depth) {
  const oracle::World world(scene);
  oracle::PictureRequest request{.camera = scene.camera, .size = {9, 9}, .output = output, .threads = 1};
  request.shading.portal_depth = depth;
  return oracle::trace(world, request).at(4, 4);
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

TEST_CASE("a mirror shows what stands before it, the other way round", "[portal]") {
  Scene scene = two_places();
  scene.portals = {{.node = 0}};
  add_node(scene, {.name = "facing the mirror", .translation = {1.5, 0, 4}, .rotation_angle = degrees(180), .mesh = 0});
  // The eye at (0.5, 2) in x and z looks at the mirror's point (0.875, 0). Reflected, the ray meets the square at z
  // = 4.
  scene.camera.eye = {0.5, 0, 2};
  scene.camera.target = {0.875, 0, 0};
  const Rgba position = middle(scene, oracle::Output::position, 1);
  CHECK(position.r == Approx(0.5 + 0.375 * 3));  // 6 m of way, 0.375 m sideways for every 2 m
  CHECK(position.b == Approx(4));
}

TEST_CASE("a portal is refused where it cannot be", "[portal]") {
  const auto words = [](const std::function<void(Scene&)>& spoil) {
    Scene scene = two_places();
    spoil(scene);
    return error_of([&] { validate(scene); });
  };
  CHECK(words([](Scene&) {}).empty());
  CHECK(mentions(words([](Scene& s) { s.portals[0].node = 9; }), {"portal 0", "node 9"}));
  CHECK(mentions(words([](Scene& s) { s.portals[1].exit = -1; }), {"portal 1", "exit -1"}));
  CHECK(mentions(words([](Scene& s) { s.nodes[1].scale = {1, 2, 1}; }), {"portal 0", "exit 1", "there", "scales"}));
  CHECK(mentions(words([](Scene& s) { s.nodes[0].scale = {1, 1, -1}; }), {"portal 0", "scales or mirrors"}));
  CHECK(mentions(words([](Scene& s) { s.nodes[0].mesh.reset(); }), {"portal 0", "no mesh"}));
  CHECK(mentions(words([](Scene& s) { s.meshes[0].vertices[2].position.z = 0.5f; }), {"portal 0", "z = 0.5"}));
  CHECK(mentions(words([](Scene& s) { s.portals[0].colour.g = -1; }), {"portal 0", "colour"}));
}
