#include "scene/scene.hpp"

#include <functional>
#include <limits>

#include "catch.hpp"
#include "scene/builder.hpp"
#include "scene/shapes.hpp"
#include "scene/sky.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

Sky grey_sky() {
  return make_sky(2, [](const glm::dvec3&) { return glm::dvec3(0.5); });
}

/// Replaces the sky by a grey one that `spoil` has changed.
void set_sky(Scene& scene, const std::function<void(Sky&)>& spoil) {
  Sky sky = grey_sky();
  spoil(sky);
  scene.sky = std::make_shared<const Sky>(std::move(sky));
}

/// A small scene with one of everything.
Scene sound_scene() {
  Scene scene{.name = "test"};
  scene.sky = std::make_shared<const Sky>(grey_sky());
  const int texture = add_texture(scene, "white", Image(2, 2, {1, 1, 1, 1}));
  const int material = add_material(scene, {.name = "paint", .diffuse_texture = texture});
  const int group = add_node(scene, {.name = "group"});
  add_object(scene, make_box(), material, {.name = "box", .parent = group});
  add_light(scene, {.name = "sun", .position = {0, 5, 0}});
  return scene;
}

}  // namespace

TEST_CASE("validate accepts valid scenes, including extremes", "[scene]") {
  struct Row {
    const char* name;
    std::function<void(Scene&)> change;
  };
  const Row table[] = {
      {"as it is", [](Scene&) {}},
      {"empty", [](Scene& s) { s = {}; }},
      {"exponents at both ends", [](Scene& s) { s.materials[0].exponent = 0, add_material(s, {.exponent = 1e6f}); }},
      {"zero and negative scale",
       [](Scene& s) {
         s.nodes[0].scale = {0, -1, 1};
       }},
      {"zero axis without a turn", [](Scene& s) { s.nodes[0].rotation_axis = glm::vec3(0); }},
      {"vertical view of 179 degrees", [](Scene& s) { s.camera.fov_y = degrees(179); }},
      {"looking along up",
       [](Scene& s) {
         s.camera.eye = {0, 5, 0}, s.camera.target = {0, 0, 0};
       }},
      {"negative near of a parallel view",
       [](Scene& s) { s.camera.projection = Projection::orthographic, s.camera.near = -5; }},
      {"cones of zero and of all around",
       [](Scene& s) {
         add_light(s, {.type = LightType::spot, .inner_angle = 0, .outer_angle = 0});
         add_light(s, {.type = LightType::spot, .inner_angle = 0, .outer_angle = degrees(180)});
       }},
      {"a zero normal", [](Scene& s) { s.meshes[0].vertices[0].normal = glm::vec3(0); }},
      {"no sky", [](Scene& s) { s.sky.reset(); }},
      {"a sky of 6 texels", [](Scene& s) { set_sky(s, [](Sky& sky) { sky.faces.fill(Image(1, 1)); }); }},
      {"a sky's alpha, which is not used",
       [](Scene& s) { set_sky(s, [](Sky& sky) { sky.faces[0].at(0, 0).a = not_a_number; }); }},
  };
  for (const Row& row : table) {
    INFO(row.name);
    Scene scene = sound_scene();
    row.change(scene);
    CHECK(error_of([&] { validate(scene); }) == "");
  }
}

TEST_CASE("validate names the first error", "[scene]") {
  struct Row {
    const char* name;
    std::function<void(Scene&)> change;
    std::vector<std::string> words;
  };
  const Row table[] = {
      {"mesh index", [](Scene& s) { s.nodes[1].mesh = 9; }, {"scene 'test': node 1 ('box'): mesh 9 of 1", "0..0"}},
      {"negative mesh", [](Scene& s) { s.nodes[1].mesh = -1; }, {"mesh -1 of 1"}},
      {"material index", [](Scene& s) { s.nodes[1].material = 1; }, {"material 1 of 1"}},
      {"texture index",
       [](Scene& s) { s.materials[0].normal_texture = 7; },
       {"material 0 ('paint')", "texture 7 of 1"}},
      {"vertex index", [](Scene& s) { s.meshes[0].indices[5] = 24; }, {"mesh 0 ('box')", "index 24 of 24"}},
      {"half a triangle", [](Scene& s) { s.meshes[0].indices.pop_back(); }, {"35 indices", "multiple of 3"}},
      {"position", [](Scene& s) { s.meshes[0].vertices[3].position.y = not_a_number; }, {"vertex 3", "position"}},
      {"normal", [](Scene& s) { s.meshes[0].vertices[0].normal.x = infinite; }, {"vertex 0", "normal"}},
      {"texcoord", [](Scene& s) { s.meshes[0].vertices[0].texcoord.x = infinite; }, {"texture coordinate"}},
      {"tangent count", [](Scene& s) { s.meshes[0].tangents.resize(3); }, {"3 tangents for 24 vertices"}},
      {"negative colour", [](Scene& s) { s.materials[0].diffuse.g = -1; }, {"diffuse"}},
      {"exponent", [](Scene& s) { s.materials[0].exponent = not_a_number; }, {"exponent nan", "0..1000000"}},
      {"empty texture", [](Scene& s) { s.textures[0].pixels = {}; }, {"texture 0 ('white')", "no pixels"}},
      {"bad pixel", [](Scene& s) { s.textures[0].pixels.at(1, 1).b = not_a_number; }, {"texture 0", "not finite"}},
      {"parent", [](Scene& s) { s.nodes[1].parent = 2; }, {"scene 'test'", "node 1", "parent 2 of 2"}},
      {"parent below -1", [](Scene& s) { s.nodes[1].parent = -2; }, {"parent -2"}},
      {"own parent", [](Scene& s) { s.nodes[0].parent = 0; }, {"scene 'test'", "node 0 ('group')", "cycle"}},
      {"cycle of two", [](Scene& s) { s.nodes[0].parent = 1; }, {"cycle"}},
      {"translation", [](Scene& s) { s.nodes[0].translation.x = infinite; }, {"node 0", "translation"}},
      {"zero axis", [](Scene& s) { s.nodes[0].rotation_axis = {}, s.nodes[0].rotation_angle = 1; }, {"axis"}},
      {"matrix", [](Scene& s) { s.nodes[0].matrix = glm::mat4(not_a_number); }, {"matrix"}},
      {"attenuation", [](Scene& s) { s.lights[0].attenuation = {}; }, {"light 0 ('sun')", "attenuation"}},
      {"cones", [](Scene& s) { s.lights[0].type = LightType::spot, s.lights[0].inner_angle = 1; }, {"cone", "inner"}},
      {"no direction",
       [](Scene& s) { s.lights[0].type = LightType::directional, s.lights[0].direction = {}; },
       {"direction"}},
      {"view of 180 degrees", [](Scene& s) { s.camera.fov_y = degrees(180); }, {"camera", "179"}},
      {"no view", [](Scene& s) { s.camera.fov_y = 0; }, {"angle of view 0"}},
      {"looking at itself", [](Scene& s) { s.camera.target = s.camera.eye; }, {"same point"}},
      {"near behind", [](Scene& s) { s.camera.near = 0; }, {"near"}},
      {"far before near", [](Scene& s) { s.camera.far = s.camera.near; }, {"near below far"}},
      {"ambient", [](Scene& s) { s.ambient.x = not_a_number; }, {"ambient"}},
      {"a sky without faces",
       [](Scene& s) { set_sky(s, [](Sky& sky) { sky = {}; }); },
       {"scene 'test': sky: face 0 (+x): 0 x 0 texels", "six squares", "1..4096"}},
      {"a face that is not square",
       [](Scene& s) { set_sky(s, [](Sky& sky) { sky.faces[3] = Image(2, 1); }); },
       {"face 3 (-y): 2 x 1"}},
      {"a larger face",
       [](Scene& s) { set_sky(s, [](Sky& sky) { sky.faces[4] = Image(3, 3); }); },
       {"face 4 (+z): 3 x 3"}},
      {"a bad texel",
       [](Scene& s) { set_sky(s, [](Sky& sky) { sky.faces[5].at(1, 0).g = infinite; }); },
       {"face 5 (-z): a texel is not finite"}},
  };
  for (const Row& row : table) {
    INFO(row.name);
    Scene scene = sound_scene();
    row.change(scene);
    const std::string message = error_of([&] { validate(scene); });
    INFO(message);
    for (const std::string& word : row.words) CHECK(mentions(message, {word}));
  }
}

TEST_CASE("world matrices compose translation, rotation and scale from the root outwards", "[scene]") {
  std::vector<Node> nodes(3);
  nodes[2] = {
      .translation = {1, 0, 0}, .rotation_axis = {0, 0, 2}, .rotation_angle = degrees(90)};  // the root comes last
  nodes[0] = {.parent = 2, .translation = {0, 2, 0}, .scale = {2, 3, 4}};
  nodes[1] = {.parent = 0, .matrix = glm::mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1)};
  const auto world = world_matrices_exact(nodes);
  const auto at = [&](int i, const glm::dvec3& p) { return glm::dvec3(world[i] * glm::dvec4(p, 1)); };
  const double tolerance = 1e-6;  // the right angle is a float: 4e-8 off, times lengths around 20
  CHECK(glm::length(at(2, {1, 0, 0}) - glm::dvec3(1, 1, 0)) < tolerance);
  CHECK(glm::length(at(0, {1, 1, 1}) - glm::dvec3(1 - 5, 2, 4)) < tolerance);
  CHECK(glm::length(at(1, {0, 0, 0}) - glm::dvec3(1 - 20, 10, 28)) < tolerance);
  CHECK(parents_first(nodes) == std::vector<int>{2, 0, 1});
}

TEST_CASE("100 000 nested nodes need no recursion, and a far world keeps its precision", "[scene]") {
  std::vector<Node> nodes(100'000);
  for (int i = 0; i < int(nodes.size()); ++i) nodes[i] = {.parent = i + 1, .translation = {1, 0.001, 0}};
  nodes.back().parent = -1;
  nodes.back().translation.x = 1e6;
  const auto world = world_matrices_exact(nodes);
  CHECK(world[0][3].x == 1e6 + 99'999);
  CHECK(world[0][3].y == Approx(100).epsilon(1e-10));  // 1e5 additions, each rounded to half an ulp
}

TEST_CASE("bounds contain exactly the drawn meshes", "[scene]") {
  CHECK(bounds(Scene{}).empty());
  Scene scene = sound_scene();
  add_mesh(scene, make_sphere({.radius = 100}));  // in no node
  scene.nodes[0].translation = {10, 0, 0};
  scene.nodes[0].scale = {1, -4, 1};
  const Box3 box = bounds(scene);
  CHECK(box.low == glm::dvec3(9.5, -2, -0.5));
  CHECK(box.high == glm::dvec3(10.5, 2, 0.5));
}
