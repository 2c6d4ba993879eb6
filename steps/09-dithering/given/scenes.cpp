#include "09-dithering/given/scenes.hpp"

#include <array>

#include "03-shadow-mapping/given/scenes.hpp"
#include "scene/builder.hpp"
#include "scene/builtin.hpp"
#include "scene/card.hpp"
#include "scene/shapes.hpp"

namespace atelier {

namespace {

/// The deck of a ship under a low sun: planks, mast, barrels, crates, a rail, and the sea.
Scene deck() {
  Scene scene{.name = "deck"};
  scene.ambient = glm::vec3(0.05f);
  scene.background = glm::vec3(0.012f);
  const int wood = add_material(scene, {.name = "wood", .diffuse = glm::vec3(0.55f)});
  const int dark = add_material(scene, {.name = "dark wood", .diffuse = glm::vec3(0.28f)});
  const int iron = add_material(scene, plastic("iron", glm::vec3(0.12f), 40));
  const int water = add_material(scene, {.name = "sea", .diffuse = glm::vec3(0.06f)});
  add_object(scene, make_plane({.width = 120, .depth = 120}), water,
             {.name = "sea", .translation = {0, -3, 0}, .casts_shadow = false});
  for (int i = -8; i <= 8; ++i)
    add_object(scene, make_box({.size = {0.56f, 0.1f, 14}}), i % 3 == 0 ? dark : wood,
               {.name = "plank", .translation = {0.6 * i, -0.05, -2}, .casts_shadow = false});
  for (const double side : {-5.1, 5.1}) {
    add_object(scene, make_box({.size = {0.18f, 0.14f, 14}}), dark, {.name = "rail", .translation = {side, 1.05, -2}});
    for (int i = 0; i < 8; ++i)
      add_object(scene, make_box({.size = {0.12f, 1, 0.12f}}), wood,
                 {.name = "post", .translation = {side, 0.5, 4.4 - 1.8 * i}});
  }
  add_object(scene, make_cylinder({.radius = 0.32f, .height = 9}), wood,
             {.name = "mast", .translation = {0.4, 0, -3.2}});
  add_object(scene, make_cylinder({.radius = 0.38f, .height = 0.15f}), iron,
             {.name = "ring", .translation = {0.4, 1.2, -3.2}});
  const std::array<glm::dvec3, 4> barrels = {glm::dvec3(-1.9, 0, -2.6), glm::dvec3(-2.75, 0, -2.2),
                                             glm::dvec3(-2.2, 0, -1.5), glm::dvec3(3.1, 0, -4.6)};
  for (const glm::dvec3& place : barrels) {
    add_object(scene, make_cylinder({.radius = 0.36f, .height = 0.95f}), dark,
               {.name = "barrel", .translation = place});
    for (const double height : {0.18, 0.66})
      add_object(scene, make_cylinder({.radius = 0.385f, .height = 0.09f}), iron,
                 {.name = "hoop", .translation = place + glm::dvec3(0, height, 0)});
  }
  add_object(scene, make_box({.size = glm::vec3(0.9f)}), wood,
             {.name = "crate", .translation = {2.2, 0.45, -1.6}, .rotation_angle = degrees(28)});
  add_object(scene, make_box({.size = glm::vec3(0.6f)}), dark,
             {.name = "crate", .translation = {2.35, 1.2, -1.7}, .rotation_angle = degrees(-12)});
  add_object(scene, make_sphere({.radius = 0.42f}), iron, {.name = "ball", .translation = {0.9, 0.42, -0.7}});
  add_object(scene, make_teapot({.height = 0.5f}), wood,
             {.name = "teapot", .translation = {-0.7, 0, -0.4}, .rotation_angle = degrees(-30)});
  add_light(scene, {.type = LightType::directional,
                    .name = "sun",
                    .direction = glm::normalize(glm::vec3(-0.75f, -0.55f, -0.35f)),
                    .colour = glm::vec3(1.15f)});
  scene.camera = {.eye = {0.2, 1.65, 3.6}, .target = {0, 0.8, -3}, .fov_y = degrees(55), .near = 0.1f, .far = 150};
  return scene;
}

}  // namespace

const SceneTable& dither_scenes() {
  static const SceneTable scenes = {
      {"teapot", [](const Settings&) { return make_teapot_scene(); }},
      {"deck", [](const Settings&) { return deck(); }},
      {"card", [](const Settings&) { return make_card_scene(); }},
      builtin_scene("room"),
  };
  return scenes;
}

}  // namespace atelier
