#include "scene/builtin.hpp"

#include <set>

#include "catch.hpp"
#include "mesh_facts.hpp"
#include "scene/builder.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

TEST_CASE("every built-in scene can be drawn", "[scene]") {
  REQUIRE(builtin_scene_names().size() >= 8);
  for (const std::string& name : builtin_scene_names()) {
    INFO(name);
    const Scene scene = make_builtin_scene(name);
    CHECK(scene.name == name);
    CHECK(error_of([&] { validate(scene); }) == "");
    CHECK(!scene.lights.empty());
    for (const Mesh& mesh : scene.meshes) {
      INFO(mesh.name);
      CHECK(test::measure(mesh).normal_length_error < 1e-6);  // rounding of three floats
    }

    // Seen from its own camera: something lies ahead, in front of the near plane and before the far one.
    const Box3 box = bounds(scene);
    const glm::dvec3 ahead = glm::normalize(scene.camera.target - scene.camera.eye);
    double nearest = 1e300, farthest = -1e300;
    for (const glm::dvec3& corner : corners_of(box)) {
      const double depth = glm::dot(corner - scene.camera.eye, ahead);
      nearest = std::min(nearest, depth);
      farthest = std::max(farthest, depth);
    }
    CHECK(nearest < scene.camera.far);
    CHECK(farthest > scene.camera.near);
  }
}

TEST_CASE("materials of built-in scenes conserve energy", "[scene]") {
  for (const std::string& name : builtin_scene_names())
    for (const Material& material : make_builtin_scene(name).materials) {
      INFO(name << ": " << material.name);
      const glm::vec3 sum = material.diffuse + material.specular;
      CHECK(std::max({sum.x, sum.y, sum.z}) <= 1 + 1e-6f);  // 1e-6: sums of rounded decimals
    }
}

TEST_CASE("an unknown scene is refused with the names of the known ones", "[scene]") {
  CHECK(mentions(error_of([] { make_builtin_scene("teapots"); }), {"'teapots'", "teapot", "robot", "hall"}));
  CHECK(mentions(error_of([] { make_builtin_scene(""); }), {"''", "teapot"}));
}

TEST_CASE("the robot is deep, and lists children before their parents", "[scene]") {
  const Scene robot = make_builtin_scene("robot");
  int deepest = 0, out_of_order = 0;
  for (int i = 0; i < int(robot.nodes.size()); ++i) {
    out_of_order += robot.nodes[i].parent > i;
    int depth = 1;
    for (int n = i; robot.nodes[n].parent >= 0; n = robot.nodes[n].parent) ++depth;
    deepest = std::max(deepest, depth);
  }
  CHECK(deepest >= 9);
  CHECK(out_of_order >= 3);

  // It stands on the ground with both feet: the soles of its feet, 5 cm below their joints, touch y = 0 within 8 cm.
  const auto world = world_matrices_exact(robot.nodes);
  for (std::size_t i = 0; i < robot.nodes.size(); ++i)
    if (robot.nodes[i].name.ends_with("foot")) CHECK(std::abs(world[i][3].y - 0.05) < 0.08);
}

TEST_CASE("upright rotates a flat picture to the yaw, with its top up", "[scene]") {
  for (const double yaw : {0.0, 0.7, 1.5707963267948966, 3.0, -2.2}) {
    INFO(yaw);
    const glm::dmat4 m = world_matrices_exact({upright({}, yaw)})[0];
    const glm::dvec3 normal(m * glm::dvec4(0, 1, 0, 0)), top(m * glm::dvec4(0, 0, -1, 0)),
        right(m * glm::dvec4(1, 0, 0, 0));
    const double tolerance = 3e-7;  // axis and angle are floats
    CHECK(glm::length(normal - glm::dvec3(std::sin(yaw), 0, std::cos(yaw))) < tolerance);
    CHECK(glm::length(top - glm::dvec3(0, 1, 0)) < tolerance);
    CHECK(glm::length(right - glm::dvec3(std::cos(yaw), 0, -std::sin(yaw))) < tolerance);
  }
}
