// Preparing a scene for tracing: positions, facing, and difficult matrices.
#include "catch.hpp"
#include "pieces.hpp"
#include "scene/builtin.hpp"

namespace atelier::test {
namespace {

using oracle::Ray;
using oracle::World;

/// One triangle in the plane z = 0 that faces +z, with the normal +z.
Mesh facing_z() {
  return {.name = "triangle",
          .vertices = {{{0, 0, 0}, {0, 0, 1}, {0, 0}}, {{2, 0, 0}, {0, 0, 1}, {1, 0}}, {{0, 2, 0}, {0, 0, 1}, {0, 1}}},
          .indices = {0, 1, 2}};
}

Scene one_triangle(Node node, bool two_sided = false) {
  Scene scene = dark_scene();
  scene.materials[0].two_sided = two_sided;
  add_object(scene, facing_z(), 0, std::move(node));
  return scene;
}

const Ray from_front{{0.5, 0.5, 5}, {0, 0, -1}}, from_behind{{0.5, 0.5, -5}, {0, 0, 1}};

}  // namespace

TEST_CASE("back faces are not hit unless they are two-sided", "[world]") {
  const struct {
    const char* name;
    bool two_sided;
    Ray ray;
    bool seen;
    glm::dvec3 normal;
  } rows[] = {{"from the front", false, from_front, true, {0, 0, 1}},
              {"from behind", false, from_behind, false, {}},
              {"two-sided from the front", true, from_front, true, {0, 0, 1}},
              {"two-sided from behind", true, from_behind, true, {0, 0, -1}}};
  for (const auto& row : rows) {
    INFO(row.name);
    const Scene scene = one_triangle({}, row.two_sided);
    const auto point = World(scene).seen(row.ray);
    CHECK(point.has_value() == row.seen);
    if (!point) continue;
    CHECK(point->normal == row.normal);
    CHECK(point->flat_normal == row.normal);
    CHECK(glm::length(point->texcoord - glm::dvec2(0.25)) < 1e-15);
    CHECK(glm::length(point->position - glm::dvec3(0.5, 0.5, 0)) < 1e-15);
  }
}

TEST_CASE("mirrored, flattened and turned models face the way that OpenGL draws them", "[world]") {
  const struct {
    const char* name;
    Node node;
    Ray ray;
    glm::dvec3 normal;
  } rows[] = {
      {"mirrored across x", {.scale = {-1, 1, 1}}, {{-0.5, 0.5, 5}, {0, 0, -1}}, {0, 0, 1}},
      {"mirrored across z", {.scale = {1, 1, -1}}, from_behind, {0, 0, -1}},
      {"mirrored twice", {.scale = {-1, -1, 1}}, {{-0.5, -0.5, 5}, {0, 0, -1}}, {0, 0, 1}},
      {"turned half way round y", {.rotation_angle = float(pi)}, {{-0.5, 0.5, -5}, {0, 0, 1}}, {0, 0, -1}},
      {"flattened along its normal", {.scale = {1, 1, 0}}, from_front, {0, 0, 1}},
      {"tiny", {.scale = glm::vec3(1e-18f)}, {{5e-19, 5e-19, 5}, {0, 0, -1}}, {0, 0, 1}},
      {"huge", {.scale = glm::vec3(1e18f)}, {{5e17, 5e17, 5}, {0, 0, -1}}, {0, 0, 1}},
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const Scene scene = one_triangle(row.node);
    const auto point = World(scene).seen(row.ray);
    REQUIRE(point);
    CHECK(glm::length(point->normal - row.normal) < 1e-7);  // a float's pi
  }
}

TEST_CASE("meshes flattened to a line or a point are invisible and harmless", "[world]") {
  for (const glm::vec3& scale : {glm::vec3(1, 0, 0), glm::vec3(0)}) {
    const Scene scene = one_triangle({.scale = scale}, true);
    const World world(scene);
    Dice dice;
    for (int i = 0; i < 100; ++i) CHECK_FALSE(world.seen({{0.5, 0.5, 5}, dice.in_cube()}));
  }
}

TEST_CASE("normals stay perpendicular to a stretched surface", "[world]") {
  Dice dice;
  for (int i = 0; i < 100; ++i) {
    glm::dmat4 model(glm::dmat3(dice.in_cube(), dice.in_cube(), dice.in_cube()));
    const glm::dvec3 along = dice.in_cube(), across = dice.in_cube(), normal = glm::cross(along, across);
    const glm::dvec3 turned = glm::normalize(oracle::normal_matrix_exact(model) * normal);
    const glm::dmat3 m(model);
    CHECK(std::abs(glm::dot(turned, glm::normalize(m * along))) < 1e-10);  // up to the model's condition times 1e-16
    CHECK(std::abs(glm::dot(turned, glm::normalize(m * across))) < 1e-10);
    CHECK(glm::dot(turned, m * normal) > 0);  // on the side that its own normal went to
  }
}

TEST_CASE("world matrices work over a thousand levels and a million metres", "[world]") {
  Scene scene = dark_scene();
  for (int i = 0; i < 1000; ++i) add_node(scene, {.parent = i - 1, .translation = {1000, 0.25, 0}});
  add_object(scene, facing_z(), 0, {.parent = 999});
  const auto point = World(scene).seen({{1e6 + 0.5, 250.5, 5}, {0, 0, -1}});
  REQUIRE(point);
  CHECK(glm::length(point->position - glm::dvec3(1e6 + 0.5, 250.5, 0)) < 1e-9);  // ulp of 1e6: 1.2e-10

  // A chain that turns by a full circle comes back to where it began.
  Scene circle = dark_scene();
  for (int i = 0; i < 1000; ++i)
    add_node(circle, {.parent = i - 1, .rotation_axis = {1, 2, 3}, .rotation_angle = float(2 * pi / 1000)});
  const glm::dmat4 last = world_matrices_exact(circle.nodes).back();
  // The angle is a float: 1000 times half an ulp of 0.006, 2.3e-10.
  for (int column = 0; column < 4; ++column) CHECK(glm::length(last[column] - glm::dmat4(1)[column]) < 1000 * 2.4e-10);
}

TEST_CASE("of surfaces at equal distance, the first in the scene is visible", "[world]") {
  Scene scene = dark_scene();
  for (int i = 0; i < 9; ++i) add_object(scene, facing_z(), 0);
  CHECK(World(scene).seen(from_front)->thing == 0);
}

TEST_CASE("only shadow casters block light, from both sides", "[world]") {
  for (const bool casts : {true, false}) {
    Scene scene = one_triangle({.casts_shadow = casts});
    const World world(scene, {{.surface = oracle::Sphere{0.5},
                               .object_to_world =
                                   [] {
                                     glm::dmat4 place(1);
                                     place[3] = {50, 0, 0, 1};
                                     return place;
                                   }(),
                               .casts_shadow = casts}});
    CHECK(world.blocked(from_front) == casts);
    CHECK(world.blocked(from_behind) == casts);
    CHECK(world.blocked({{50, 9, 0}, {0, -1, 0}}) == casts);
    CHECK_FALSE(world.blocked({from_front.origin, from_front.direction, 0, 4.9}));  // the light stands before it
  }
}

TEST_CASE("the built-in scenes come with all their triangles", "[world]") {
  for (const std::string& name : builtin_scene_names()) {
    INFO(name);
    const Scene scene = make_builtin_scene(name);
    std::size_t expected = 0;
    for (const Node& node : scene.nodes)
      if (node.mesh) expected += scene.meshes[std::size_t(*node.mesh)].indices.size() / 3;
    const World world(scene);
    CHECK(world.triangle_count() == expected);
    CHECK(world.tree().depth() < 40);
    const auto middle = world.seen(oracle::CameraRays(scene.camera, {1, 1}).through({0.5, 0.5}));
    CHECK(middle);
  }
}

TEST_CASE("an invalid scene is refused", "[world]") {
  Scene scene = one_triangle({});
  scene.nodes[0].material = 3;
  CHECK(mentions(error_of([&] { World world(scene); }), {"scene 'test'", "material 3"}));
}

}  // namespace atelier::test
