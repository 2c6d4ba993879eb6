// Which portals a scene may have.
#include <functional>
#include <numbers>

#include "catch.hpp"
#include "scene/builder.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

/// A flat rhombus in the plane z = 0, facing +z, 2 m wide and 4 m high.
Mesh rhombus() {
  const auto corner = [](float x, float y) { return Vertex{{x, y, 0}, {0, 0, 1}, {0, 0}}; };
  return {.name = "rhombus",
          .vertices = {corner(1, 0), corner(0, 2), corner(-1, 0), corner(0, -2)},
          .indices = {0, 1, 2, 0, 2, 3}};
}

/// Two portals that lead to each other, and a mirror.
Scene portal_scene() {
  Scene scene{.name = "test"};
  add_material(scene, {.name = "opening"});
  const int mesh = add_mesh(scene, rhombus());
  const int here = add_node(scene, {.name = "here", .mesh = mesh});
  const int there = add_node(
      scene,
      {.name = "there", .translation = {1e6, 0, 5}, .rotation_axis = {1, 2, 3}, .rotation_angle = 1, .mesh = mesh});
  const int mirror = add_node(scene, {.name = "mirror", .translation = {0, 0, 9}, .mesh = mesh});
  scene.portals = {{.node = here, .exit = there}, {.node = there, .exit = here}, {.node = mirror}};
  return scene;
}

std::string words_for(const std::function<void(Scene&)>& change) {
  Scene scene = portal_scene();
  change(scene);
  return error_of([&] { validate(scene); });
}

/// Another mirror at an offset from the node `here`, facing the other way.
void add_back_to_back(Scene& scene, const glm::vec3& offset) {
  const int back = add_node(scene, {.name = "back",
                                    .translation = offset,
                                    .rotation_axis = {0, 1, 0},
                                    .rotation_angle = std::numbers::pi_v<float>,
                                    .mesh = 0});
  scene.portals.push_back({.node = back});
}

void move_corners(Scene& scene, const glm::vec3& by) {
  for (Vertex& vertex : scene.meshes[0].vertices) vertex.position += by;
}

}  // namespace

TEST_CASE("validate accepts portals and mirrors", "[scene]") {
  struct Row {
    const char* name;
    std::function<void(Scene&)> change;
  };
  const Row table[] = {
      {"as they are", [](Scene&) {}},
      {"an exit without a portal", [](Scene& s) { s.portals[0].exit = add_node(s, {.name = "exit"}); }},
      {"an exit that is the entry", [](Scene& s) { s.portals[0].exit = 0; }},
      {"two portals with one exit", [](Scene& s) { s.portals[1].exit = s.portals[0].exit; }},
      {"an opening beside an exit, in its plane",
       [](Scene& s) {
         add_back_to_back(s, {2.5f, 0, 0});
       }},
      {"the two sides of a door",
       [](Scene& s) {
         add_back_to_back(s, {0, 0, -0.01f});
       }},
      {"straight on",
       [](Scene& s) {
         add_back_to_back(s, {0, 0, 0});
         s.portals.pop_back();
         s.portals[0].exit = 3;
       }},
      {"corners off by rounding",
       [](Scene& s) {
         move_corners(s, {1e-7f, -1e-7f, 0});
       }},
      {"a triangle without area",
       [](Scene& s) {
         s.meshes[0].indices.insert(s.meshes[0].indices.end(), {1, 1, 2});
       }},
  };
  for (const Row& row : table) {
    INFO(row.name);
    CHECK(words_for(row.change) == "");
  }
}

TEST_CASE("validate refuses portals that cannot be entered", "[scene]") {
  struct Row {
    const char* name;
    std::function<void(Scene&)> change;
    std::vector<std::string> words;
  };
  const Row table[] = {
      {"node", [](Scene& s) { s.portals[0].node = 9; }, {"scene 'test': portal 0: node 9 of 3", "0..2"}},
      {"exit", [](Scene& s) { s.portals[1].exit = -1; }, {"portal 1: exit -1 of 3"}},
      {"scaled exit",
       [](Scene& s) {
         s.nodes[1].scale = {1, 2, 1};
       },
       {"portal 0: exit 1 ('there') scales"}},
      {"mirrored node",
       [](Scene& s) {
         s.nodes[0].scale = {1, 1, -1};
       },
       {"portal 0: node 0", "scales or mirrors"}},
      {"two on one node",
       [](Scene& s) { s.portals[2].node = 0; },
       {"portal 2: portal 0 is on node 0 ('here') too", "one portal a node"}},
      {"no mesh", [](Scene& s) { s.nodes[0].mesh.reset(); }, {"portal 0", "no mesh"}},
      {"no triangle", [](Scene& s) { s.meshes[0].indices.clear(); }, {"portal 0", "no triangle with an area"}},
      {"no area",
       [](Scene& s) {
         s.meshes[0].indices = {0, 2, 0};
       },
       {"portal 0", "no triangle with an area"}},
      {"not in the plane", [](Scene& s) { s.meshes[0].vertices[2].position.z = 0.5f; }, {"portal 0", "z = 0.5"}},
      {"facing back",
       [](Scene& s) { std::swap(s.meshes[0].indices[4], s.meshes[0].indices[5]); },
       {"triangle 1", "-z"}},
      {"beside the origin",
       [](Scene& s) {
         move_corners(s, {0.5f, 0, 0});
       },
       {"from x = -0.5 to 1.5", "x = 0)"}},
      {"above the origin",
       [](Scene& s) {
         move_corners(s, {0, 2, 0});
       },
       {"from y = 0 to 4", "y = 0)"}},
      {"colour", [](Scene& s) { s.portals[0].colour.g = -1; }, {"portal 0", "colour"}},
      {"back to back",
       [](Scene& s) {
         add_back_to_back(s, {0.5f, 0.2f, 0});
       },
       {"portal 1: the opening of node 3 ('back')", "exit, node 0 ('here')", "a distance"}},
      {"both sides of one plane",
       [](Scene& s) {
         s.materials[0].two_sided = true;
         s.portals[1].exit = add_node(s, {.name = "exit"});
       },
       {"portal 1: the opening of node 0 ('here')", "exit, node 3 ('exit')"}},
      {"an orthographic camera",
       [](Scene& s) { s.camera.projection = Projection::orthographic; },
       {"camera", "orthographic", "perspective"}},
  };
  for (const Row& row : table) {
    INFO(row.name);
    const std::string message = words_for(row.change);
    INFO(message);
    for (const std::string& word : row.words) CHECK(mentions(message, {word}));
  }
}
