#include "10-artstyles/given/scenes.hpp"

#include <array>

#include "03-shadow-mapping/given/scenes.hpp"
#include "scene/builder.hpp"
#include "scene/builtin.hpp"
#include "scene/card.hpp"
#include "scene/shapes.hpp"
#include "scene/textures.hpp"

namespace atelier {

namespace {

void add_bottle(Scene& scene, int glass, const glm::dvec3& place) {
  const int bottle = add_node(scene, {.name = "bottle", .translation = place});
  const auto part = [&](Mesh mesh, double height) {
    add_object(scene, std::move(mesh), glass, {.name = "bottle", .parent = bottle, .translation = {0, height, 0}});
  };
  part(make_cylinder({.radius = 0.16f, .height = 0.55f}), 0);
  part(make_cone({.radius = 0.16f, .height = 0.3f}), 0.55);
  part(make_cylinder({.radius = 0.05f, .height = 0.42f}), 0.55);
  part(make_cylinder({.radius = 0.062f, .height = 0.06f}), 0.91);
}

/// A still life on a table: fruit, a bottle, a copper teapot, in the light of a window.
Scene still_life() {
  Scene scene{.name = "still-life"};
  scene.ambient = glm::vec3(0.2f);
  scene.background = {0.16f, 0.11f, 0.09f};
  const int wall = add_material(scene, {.name = "wall", .diffuse = {0.42f, 0.36f, 0.24f}});
  const int boards = add_texture(scene, "boards", make_wood({.size = 256, .boards = 5}));
  const int table = add_material(scene, {.name = "table", .diffuse = glm::vec3(0.9f), .diffuse_texture = boards});
  const int cloth = add_material(scene, {.name = "cloth", .diffuse = {0.75f, 0.77f, 0.85f}});
  const int apple = add_material(scene, plastic("apple", {0.72f, 0.05f, 0.04f}, 40));
  const int pear = add_material(scene, plastic("pear", {0.5f, 0.6f, 0.08f}, 30));
  const int orange = add_material(scene, plastic("orange", {0.95f, 0.36f, 0.02f}, 20));
  const int plum = add_material(scene, plastic("plum", {0.16f, 0.04f, 0.2f}, 60));
  const int glass = add_material(scene, plastic("bottle", {0.02f, 0.13f, 0.06f}, 120));
  const int copper = add_material(scene, metal("copper", copper_reflectance, 40));
  add_object(scene, make_plane({.width = 8, .depth = 5}), wall,
             upright({.name = "wall", .translation = {0, 1, -1.2}}, 0));
  add_object(scene, make_plane({.width = 6, .depth = 3, .repeat = {2, 1}}), table,
             {.name = "table", .translation = {0, 0, 0.3}});
  add_object(scene, make_box({.size = {1.3f, 0.012f, 1}}), cloth,
             {.name = "cloth", .translation = {0.25, 0.006, 0.5}, .rotation_angle = degrees(24)});
  add_object(scene, make_teapot({.height = 0.5f}), copper,
             {.name = "teapot", .translation = {-0.55, 0, -0.3}, .rotation_angle = degrees(200)});
  add_bottle(scene, glass, {0.7, 0, -0.45});
  const auto fruit = [&](const char* name, int skin, float radius, double x, double z) {
    add_object(scene, make_sphere({.radius = radius}), skin, {.name = name, .translation = {x, double(radius), z}});
  };
  fruit("apple", apple, 0.15f, 0.05, 0.35);
  fruit("apple", apple, 0.16f, 0.38, 0.15);
  fruit("orange", orange, 0.17f, 0.15, 0.0);
  fruit("orange", orange, 0.16f, 0.72, 0.45);
  for (int i = 0; i < 4; ++i) fruit("plum", plum, 0.075f, -0.45 + 0.13 * i, 0.62 + 0.05 * (i % 2));
  add_object(scene, make_sphere({.radius = 0.15f}), pear, {.name = "pear", .translation = {-0.28, 0.17, 0.3}});
  add_object(scene, make_cone({.radius = 0.13f, .height = 0.3f}), pear,
             {.name = "pear", .translation = {-0.28, 0.2, 0.3}});
  add_light(scene, {.type = LightType::directional,
                    .name = "window",
                    .direction = glm::normalize(glm::vec3(0.75f, -0.6f, -0.45f)),
                    .colour = {1.25f, 1.15f, 0.95f}});
  scene.camera = {.eye = {0.1, 0.95, 2.6}, .target = {0.1, 0.3, 0}, .fov_y = degrees(38), .near = 0.1f, .far = 20};
  return scene;
}

/// White bodies in the same light from everywhere: only their depths and normals tell them apart.
Scene blocks() {
  Scene scene{.name = "blocks"};
  scene.ambient = glm::vec3(0.8f);
  scene.background = glm::vec3(0.8f);
  const int white = add_material(scene, {.name = "white", .diffuse = glm::vec3(1)});
  add_object(scene, make_plane({.width = 12, .depth = 12}), white, {.name = "floor"});
  // Parallel cards: between them only the depth changes.
  for (int i = 0; i < 3; ++i)
    add_object(scene, make_box({.size = {1.1f, 1.3f - 0.25f * float(i), 0.02f}}), white,
               {.name = "card", .translation = {-1.5 + 0.32 * i, 0.65 - 0.125 * i, -0.6 + 0.3 * i}});
  // Edges and corners of one body, steps, a round one: between them only the normal changes.
  add_object(scene, make_box({.size = glm::vec3(0.9f)}), white,
             {.name = "box", .translation = {0.35, 0.45, -0.3}, .rotation_angle = degrees(33)});
  add_object(scene, make_box({.size = glm::vec3(0.4f)}), white,
             {.name = "box", .translation = {0.3, 1.1, -0.35}, .rotation_angle = degrees(10)});
  for (int i = 0; i < 3; ++i)
    add_object(scene, make_box({.size = {0.8f, 0.2f, 0.3f}}), white,
               {.name = "step", .translation = {1.75, 0.1 + 0.2 * i, 0.4 - 0.3 * i}, .rotation_angle = degrees(-14)});
  add_object(scene, make_sphere({.radius = 0.3f}), white, {.name = "ball", .translation = {-0.35, 0.3, 0.75}});
  add_object(scene, make_cylinder({.radius = 0.22f, .height = 0.5f}), white,
             {.name = "drum", .translation = {0.75, 0, 0.85}});
  scene.camera = {.eye = {0.4, 2.1, 4.2}, .target = {0.1, 0.45, 0}, .fov_y = degrees(40), .near = 0.1f, .far = 30};
  return scene;
}

}  // namespace

const SceneTable& style_scenes() {
  static const SceneTable scenes = {
      {"still-life", [](const Settings&) { return still_life(); }},
      {"blocks", [](const Settings&) { return blocks(); }},
      {"teapot", [](const Settings&) { return make_teapot_scene(); }},
      {"card", [](const Settings&) { return make_card_scene(); }},
      builtin_scene("room"),
  };
  return scenes;
}

}  // namespace atelier
