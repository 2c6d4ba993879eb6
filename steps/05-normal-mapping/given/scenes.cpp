#include "05-normal-mapping/given/scenes.hpp"

#include <array>

#include "scene/builder.hpp"
#include "scene/relief.hpp"
#include "scene/shapes.hpp"

namespace atelier {

namespace {

/// What a coloured relief is made of.
Material glazed(const char* name, float specular, float exponent) {
  return {.name = name, .diffuse = glm::vec3(1 - specular), .specular = glm::vec3(specular), .exponent = exponent};
}

/// What a relief of one plain colour is made of.
Material plain(const char* name, const glm::vec3& colour) {
  return {.name = name, .diffuse = colour, .specular = glm::vec3(0.25f), .exponent = 40};
}

/// A brick wall with a lamp close to it: light at a flat angle shows the relief.
Scene wall() {
  Scene scene{.name = "wall"};
  scene.ambient = glm::vec3(0.05f);
  const int bricks =
      add_relief(scene, glazed("bricks", 0.1f, 30), make_bricks({.size = 256, .columns = 3, .rows = 6}), true);
  add_object(scene, make_plane({.width = 2, .depth = 2}), bricks, upright({.name = "wall"}, degrees(30)));
  add_light(scene, {.type = LightType::point, .position = {-0.45, 0.8, 0.95}, .colour = {1.0f, 0.9f, 0.75f}});
  scene.camera = {.eye = {0.1, 0.2, 2.8}, .target = {0, 0, 0}, .fov_y = degrees(48), .near = 0.1f, .far = 10};
  return scene;
}

/// A word carved into two slabs: on the left as it is, on the right with a mirrored texture. Light comes from the upper
/// left, so the upper left edge of every stroke is dark and the lower right edge bright, on both.
Scene inscription() {
  Scene scene{.name = "inscription"};
  scene.ambient = glm::vec3(0.06f);
  const int stone = add_relief(scene, glazed("stone", 0.05f, 20), make_inscription({.size = 512}), true);
  Mesh slab = make_plane({.width = 1.6f, .depth = 1});
  for (Vertex& vertex : slab.vertices) vertex.texcoord.y = 0.34f + 0.32f * vertex.texcoord.y;
  Mesh mirrored = slab;
  for (Vertex& vertex : mirrored.vertices) vertex.texcoord.x = 1 - vertex.texcoord.x;
  add_object(scene, slab, stone, upright({.name = "slab", .translation = {-0.82, 0, 0}}, degrees(20)));
  add_object(scene, mirrored, stone, upright({.name = "mirrored slab", .translation = {0.82, 0, 0}}, degrees(-20)));
  add_light(scene, {.type = LightType::directional, .direction = {0.7f, -0.6f, -0.5f}, .colour = glm::vec3(0.9f)});
  scene.camera = {.eye = {0, 0, 4.6}, .target = {0, 0, 0}, .fov_y = degrees(32), .near = 0.1f, .far = 10};
  return scene;
}

/// Dimples on a plate, straight from above, under a light from the upper left.
Scene dimples(const Settings& settings) {
  Scene scene{.name = "dimples"};
  scene.ambient = glm::vec3(0.04f);
  const Relief relief = make_dimples({.size = settings.integer("map.size")});
  const int clay = add_relief(scene, plain("clay", {0.6f, 0.42f, 0.3f}), relief, false);
  add_object(scene, make_plane({.width = 2, .depth = 2}), clay, {.name = "plate"});
  add_light(scene, {.type = LightType::directional, .direction = {0.6f, -0.7f, 0.5f}, .colour = glm::vec3(0.9f)});
  scene.camera = {
      .eye = {0, 3, 0}, .target = {0, 0, 0}, .up = {0, 0, -1}, .fov_y = degrees(38), .near = 0.5f, .far = 10};
  return scene;
}

/// A golf ball: a sphere whose texture has a seam and two poles.
Scene ball(const Settings& settings) {
  Scene scene{.name = "ball"};
  scene.ambient = glm::vec3(0.04f);
  const int segments = settings.integer("ball.segments");
  const int white =
      add_relief(scene, plain("white", glm::vec3(0.7f)), make_dimples({.size = 256, .dimples = 8}), false);
  Mesh mesh = make_sphere({.radius = 1, .segments = segments, .rings = segments / 2});
  for (Vertex& vertex : mesh.vertices) vertex.texcoord *= glm::vec2(2, 1);
  add_object(scene, mesh, white, {.name = "ball", .rotation_axis = {1, 0, -0.3f}, .rotation_angle = degrees(40)});
  add_light(scene, {.type = LightType::point, .position = {-2.2, 2.4, 2.6}, .colour = glm::vec3(9)});
  scene.camera = {.eye = {0, 0.2, 3.6}, .target = {0, 0, 0}, .fov_y = degrees(38), .near = 0.5f, .far = 10};
  return scene;
}

/// One corner of a hand-made mesh.
struct Point {
  glm::vec2 at, texcoord;
};

/// A flat piece in the plane z = 0 that faces +z.
Mesh piece(const std::vector<Point>& points, std::vector<std::uint32_t> indices) {
  Mesh mesh;
  for (const Point& p : points) mesh.vertices.push_back({glm::vec3(p.at, 0), {0, 0, 1}, p.texcoord});
  mesh.indices = std::move(indices);
  return mesh;
}

/// Four square plates with the same relief. From left to right: as it should be; one corner pulled onto its neighbour's
/// texture coordinate, so that the lower right triangle has no frame (its two shared corners keep theirs); every corner
/// with the same texture coordinate; a texture coordinate that varies along one line only. The last two have no frame
/// at all and must look as if they had no map. In front of them a cone, whose tip has many corners.
Scene degenerate() {
  Scene scene{.name = "degenerate"};
  scene.ambient = glm::vec3(0.05f);
  const int clay =
      add_relief(scene, plain("clay", {0.6f, 0.42f, 0.3f}), make_dimples({.size = 128, .dimples = 2}), false);
  const auto plate = [&](const char* name, double x, const std::array<glm::vec2, 4>& texcoords) {
    const std::vector<Point> points = {
        {{0, 0}, texcoords[0]}, {{1, 0}, texcoords[1]}, {{1, 1}, texcoords[2]}, {{0, 1}, texcoords[3]}};
    add_object(scene, piece(points, {0, 2, 3, 0, 1, 2}), clay, {.name = name, .translation = {x, 0, 0}});
  };
  plate("healthy", -2.3, {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  plate("two equal corners", -1.1, {{{0, 0}, {1, 1}, {1, 1}, {0, 1}}});
  plate("one point", 0.1, {{{0.3f, 0.4f}, {0.3f, 0.4f}, {0.3f, 0.4f}, {0.3f, 0.4f}}});
  plate("one line", 1.3, {{{0, 0}, {0.5f, 0.25f}, {1, 0.5f}, {0.5f, 0.25f}}});
  Mesh cone = make_cone({.radius = 0.6f, .height = 1, .segments = 12});
  for (Vertex& vertex : cone.vertices) vertex.texcoord *= glm::vec2(4, 1);
  add_object(scene, cone, clay, {.name = "cone", .translation = {0, -1.3, 0.5}});
  add_light(scene, {.type = LightType::directional, .direction = {0.6f, -0.6f, -0.6f}, .colour = glm::vec3(0.9f)});
  scene.camera = {.eye = {0, -0.1, 5.9}, .target = {0, -0.1, 0}, .fov_y = degrees(36), .near = 0.5f, .far = 12};
  return scene;
}

/// The same inscribed slab under four transforms: turned, stretched, mirrored, and seen from behind.
Scene transformed() {
  Scene scene{.name = "transformed"};
  scene.ambient = glm::vec3(0.06f);
  Relief relief = make_dimples({.size = 128, .dimples = 3});
  const int clay = add_relief(scene, plain("clay", {0.6f, 0.42f, 0.3f}), relief, false);
  Material thin = scene.materials[std::size_t(clay)];
  thin.two_sided = true;
  const int sheet = add_material(scene, thin);
  const int mesh = add_mesh(scene, make_plane({.width = 1, .depth = 1}));
  const auto place = [&](const char* name, const glm::dvec3& at, int material, const glm::vec3& scale, double roll) {
    Node node = upright({.name = name, .translation = at}, 0);
    node.scale = scale;
    node.mesh = mesh;
    node.material = material;
    const int turned = add_node(scene, {.name = "turn", .rotation_axis = {0, 0, 1}, .rotation_angle = degrees(roll)});
    scene.nodes[std::size_t(turned)].translation = at;
    node.translation = glm::dvec3(0);
    node.parent = turned;
    add_node(scene, node);
  };
  place("turned", {-1.2, 0.65, 0}, clay, glm::vec3(1), 30);
  place("stretched", {0.6, 0.65, 0}, clay, {2, 1, 0.6f}, 0);
  place("mirrored", {-1.2, -0.65, 0}, clay, {-1, 1, 1}, 0);
  Node behind = upright({.name = "from behind", .translation = {0.6, -0.65, 0}}, degrees(180));
  behind.mesh = mesh;
  behind.material = sheet;
  add_node(scene, behind);
  add_light(scene, {.type = LightType::directional, .direction = {0.6f, -0.6f, -0.6f}, .colour = glm::vec3(0.9f)});
  scene.camera = {.eye = {0, 0, 4.9}, .target = {0, 0, 0}, .fov_y = degrees(36), .near = 0.5f, .far = 12};
  return scene;
}

/// A floor of glazed tiles to the horizon, with a low light ahead: far away one pixel covers many texels.
Scene floor() {
  Scene scene{.name = "floor"};
  scene.ambient = glm::vec3(0.05f);
  scene.background = {0.3f, 0.36f, 0.45f};
  const int tiles = add_relief(scene, glazed("tiles", 0.4f, 120), make_tiles({.size = 256}), true, Filter::mipmap);
  add_object(scene, make_plane({.width = 30, .depth = 30, .repeat = {15, 15}}), tiles, {.name = "floor"});
  add_light(scene, {.type = LightType::directional, .direction = {0.1f, -0.45f, 1}, .colour = glm::vec3(0.8f)});
  scene.camera = {.eye = {0, 1.1, 6}, .target = {0, 0.4, 0}, .fov_y = degrees(50), .near = 0.1f, .far = 60};
  return scene;
}

}  // namespace

const SceneTable& normal_mapping_scenes() {
  static const SceneTable scenes = {
      {"wall", [](const Settings&) { return wall(); }},
      {"inscription", [](const Settings&) { return inscription(); }},
      {"dimples", dimples},
      {"ball", ball},
      {"degenerate", [](const Settings&) { return degenerate(); }},
      {"transformed", [](const Settings&) { return transformed(); }},
      {"floor", [](const Settings&) { return floor(); }},
      builtin_scene("room"),
      builtin_scene("hall"),
  };
  return scenes;
}

std::vector<SettingSpec> normal_mapping_scene_settings() {
  return {
      {.name = "ball.segments", .fallback = 32, .low = 4, .high = 512, .help = "meridians of the ball"},
      {.name = "map.size", .fallback = 256, .low = 8, .high = 2048, .help = "texels along a side of the dimples' maps"},
  };
}

}  // namespace atelier
