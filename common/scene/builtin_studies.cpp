#include <fmt/format.h>

#include <cmath>

#include "scene/builder.hpp"
#include "scene/builtin_scenes.hpp"
#include "scene/relief.hpp"
#include "scene/shapes.hpp"
#include "scene/textures.hpp"

namespace atelier::builtin {
namespace {

/// A floor of light and dark squares, `side` metres each way, one square half a metre.
void add_checker_floor(Scene& scene, float side, const Rgba& light, const Rgba& dark) {
  const int squares = add_texture(scene, "squares", make_checker({.squares = 2, .first = light, .second = dark}));
  const int material = add_material(scene, {.name = "floor", .diffuse = {1, 1, 1}, .diffuse_texture = squares});
  const Mesh plane = make_plane({.width = side, .depth = side, .repeat = {side, side}, .columns = 8, .rows = 8});
  add_object(scene, plane, material, {.name = "floor", .casts_shadow = false});
}

}  // namespace

Scene teapot() {
  Scene scene;
  const int wood = add_texture(scene, "wood", make_wood({.size = 256}));
  const int table = add_material(scene, {.name = "table",
                                         .diffuse = glm::vec3(0.9f),
                                         .specular = glm::vec3(0.1f),
                                         .exponent = 40,
                                         .diffuse_texture = wood});
  const int plaster = add_material(scene, {.name = "plaster", .diffuse = {0.55f, 0.6f, 0.58f}});
  const int glaze = add_material(scene, plastic("glaze", {0.62f, 0.13f, 0.07f}, 120));

  add_object(scene, make_plane({.width = 9, .depth = 5, .repeat = {3, 2}, .columns = 18, .rows = 10}), table,
             {.name = "table", .translation = {0, 0, 0.5}});
  add_object(scene, make_plane({.width = 9, .depth = 5, .columns = 18, .rows = 10}), plaster,
             upright({.name = "wall", .translation = {0, 2.5, -2}}, 0));
  add_object(scene, make_teapot({.height = 1, .subdivisions = 16}), glaze,
             {.name = "teapot", .translation = {-0.1, 0, 0}, .rotation_angle = degrees(25)});

  hang_lamp(scene, {-1.15, 3.4, 0.35}, 1.2f, glm::vec3(4.4f, 3.9f, 3.2f));
  add_light(scene, {.type = LightType::directional,
                    .name = "window",
                    .direction = {-0.6f, -0.5f, -0.7f},
                    .colour = {0.32f, 0.36f, 0.42f},
                    .casts_shadow = false});
  scene.ambient = {0.06f, 0.06f, 0.07f};
  scene.background = {0.02f, 0.02f, 0.025f};
  scene.camera = {.eye = {0.55, 1.75, 4.3}, .target = {-0.1, 0.92, 0}, .fov_y = degrees(42), .near = 0.2f, .far = 20};
  return scene;
}

Scene sphere() {
  Scene scene;
  add_checker_floor(scene, 12, {0.7f, 0.7f, 0.68f}, {0.08f, 0.1f, 0.13f});
  const int blue = add_material(scene, plastic("blue", {0.08f, 0.2f, 0.6f}, 64));
  add_object(scene, make_sphere({.radius = 1, .segments = 96, .rings = 48}), blue,
             {.name = "sphere", .translation = {0, 1, 0}});
  add_light(scene, {.name = "key", .position = {2.5, 4, 3}, .colour = glm::vec3(20)});
  scene.ambient = glm::vec3(0.06f);
  scene.background = {0.18f, 0.24f, 0.33f};
  scene.camera = {.eye = {0, 1.6, 4.6}, .target = {0, 0.9, 0}, .fov_y = degrees(40), .near = 0.2f, .far = 30};
  return scene;
}

Scene primitives() {
  Scene scene;
  add_checker_floor(scene, 14, {0.42f, 0.42f, 0.4f}, {0.28f, 0.29f, 0.3f});
  const Relief bricks = make_bricks({.size = 256});
  const auto textured = [&](const char* name, Image pixels, float gloss) {
    const int texture = add_texture(scene, name, std::move(pixels));
    return add_material(scene, {.name = name,
                                .diffuse = glm::vec3(1 - gloss),
                                .specular = glm::vec3(gloss),
                                .exponent = 50,
                                .diffuse_texture = texture});
  };
  const int grid = textured("grid", make_uv_grid(), 0.1f), wood = textured("wood", make_wood({.size = 256}), 0.1f);
  const int marble = textured("marble", make_marble({.size = 256}), 0.3f), dots = textured("dots", make_dots(), 0.15f);
  const int brick = textured("bricks", bricks.colour, 0.0f);
  scene.materials[brick].normal_texture = add_texture(scene, "brick normals", bricks.normal);
  scene.materials[brick].height_texture = add_texture(scene, "brick heights", bricks.height);
  const int stone = add_material(scene, plastic("stone", {0.5f, 0.45f, 0.15f}, 20));

  const float turn = degrees(-30);
  add_object(scene, make_sphere({.radius = 0.5f}), grid, {.name = "sphere", .translation = {-2.1, 0.5, -1.5}});
  add_object(scene, make_icosphere({.radius = 0.5f}), stone, {.name = "icosphere", .translation = {-0.75, 0.5, -1.5}});
  add_object(scene, make_teapot({.height = 0.8f}), marble,
             {.name = "teapot", .translation = {0.65, 0, -1.5}, .rotation_angle = degrees(15)});
  add_object(scene, make_plane({.width = 1.1f, .depth = 1.1f}), grid,
             upright({.name = "plane", .translation = {2.15, 0.56, -1.5}}, turn));
  add_object(scene, make_box({.size = glm::vec3(0.85f)}), brick,
             {.name = "box", .translation = {-2.0, 0.425, 0.6}, .rotation_angle = degrees(28)});
  add_object(
      scene, make_torus({.ring_radius = 0.42f, .tube_radius = 0.18f}), dots,
      {.name = "torus", .translation = {-0.8, 0.52, 0.6}, .rotation_axis = {1, 0, 0}, .rotation_angle = degrees(55)});
  add_object(scene, make_cylinder({.radius = 0.4f, .height = 0.9f}), wood,
             {.name = "cylinder", .translation = {0.3, 0, 0.6}});
  add_object(scene, make_cone({.radius = 0.45f, .height = 1}), dots, {.name = "cone", .translation = {1.35, 0, 0.6}});
  add_object(scene, make_disc({.radius = 0.4f}), grid,
             {.name = "disc", .translation = {2.35, 0.02, 0.75}, .receives_shadow = false});

  add_light(scene, {.name = "key", .position = {-3, 5, 4}, .colour = glm::vec3(26, 25, 23)});
  add_light(scene, {.name = "fill", .position = {4, 3, 3}, .colour = glm::vec3(4, 5, 6), .casts_shadow = false});
  scene.ambient = glm::vec3(0.08f);
  scene.background = {0.3f, 0.36f, 0.42f};
  scene.camera = {.eye = {0.1, 4.3, 6.2}, .target = {0.1, 0.25, -0.35}, .fov_y = degrees(34), .near = 0.2f, .far = 30};
  return scene;
}

Scene materials() {
  Scene scene;
  const int slate = add_material(scene, {.name = "slate", .diffuse = {0.1f, 0.11f, 0.13f}});
  add_object(scene, make_plane({.width = 16, .depth = 10, .columns = 16, .rows = 10}), slate,
             upright({.name = "board", .translation = {0, 0, -1}}, 0));

  const int ball = add_mesh(scene, make_sphere({.radius = 0.46f, .segments = 64, .rings = 32}));
  for (int column = 0; column < 4; ++column) {
    const float exponent = float(8 << (2 * column));  // 8, 32, 128, 512
    const Material kinds[] = {plastic("plastic", {0.05f, 0.32f, 0.12f}, exponent),
                              metal("copper", copper_reflectance, exponent), metal("gold", gold_reflectance, exponent),
                              metal("silver", silver_reflectance, exponent)};
    for (int row = 0; row < 4; ++row) {
      Material material = kinds[row];
      material.name = fmt::format("{} {}", material.name, exponent);
      add_node(scene, {.name = material.name,
                       .translation = {column - 1.5, 1.5 - row, 0},
                       .mesh = ball,
                       .material = add_material(scene, material)});
    }
  }
  add_light(scene, {.name = "key", .position = {-4, 5, 6}, .colour = glm::vec3(62)});
  add_light(scene, {.name = "rim", .position = {5, -2, 3}, .colour = glm::vec3(6, 8, 11), .casts_shadow = false});
  scene.ambient = glm::vec3(0.05f);
  scene.camera = {.eye = {0, 0, 8}, .target = {0, 0, 0}, .fov_y = degrees(30), .near = 1, .far = 20};
  return scene;
}

Scene lights() {
  Scene scene;
  const int stage =
      add_material(scene, {.name = "stage", .diffuse = glm::vec3(0.65f), .specular = glm::vec3(0.08f), .exponent = 20});
  const int china = add_material(scene, plastic("china", glm::vec3(0.8f), 90));
  add_object(scene, make_plane({.width = 40, .depth = 40, .columns = 80, .rows = 80}), stage, {.name = "stage"});
  add_object(scene, make_teapot({.height = 1, .subdivisions = 16}), china,
             {.name = "teapot", .rotation_angle = degrees(-20)});

  const auto spot = [&](const char* name, double turn, const glm::vec3& colour) {
    const glm::dvec3 position(3.2 * std::cos(turn), 3.6, 3.2 * std::sin(turn));
    const glm::dvec3 aim(0.8 * std::cos(turn), 0.1, 0.8 * std::sin(turn));
    add_light(scene, {.type = LightType::spot,
                      .name = name,
                      .position = position,
                      .direction = glm::vec3(glm::normalize(aim - position)),
                      .colour = colour,
                      .inner_angle = degrees(14),
                      .outer_angle = degrees(19)});
  };
  spot("red spot", degrees(150), {11, 1.0f, 0.7f});
  spot("green spot", degrees(90), {0.8f, 8, 1.4f});
  spot("blue spot", degrees(30), {0.9f, 1.8f, 13});
  add_light(scene, {.name = "candle", .position = {-1.6, 0.5, 1.5}, .colour = {0.3f, 0.2f, 0.09f}});
  add_light(scene, {.type = LightType::directional,
                    .name = "moon",
                    .direction = {0.5f, -1, -0.6f},
                    .colour = {0.07f, 0.08f, 0.11f}});
  scene.ambient = glm::vec3(0.01f);
  scene.camera = {.eye = {0, 2.7, 4.6}, .target = {0, 0.3, 0.1}, .fov_y = degrees(38), .near = 0.2f, .far = 25};
  return scene;
}

}  // namespace atelier::builtin
