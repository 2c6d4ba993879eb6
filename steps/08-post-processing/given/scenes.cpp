#include "08-post-processing/given/scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/builder.hpp"
#include "scene/shapes.hpp"
#include "scene/textures.hpp"

namespace atelier {

namespace {

/// A square that shows one colour, whatever the light.
void add_patch(Scene& scene, const glm::vec3& colour, const glm::dvec2& centre, const glm::vec2& size) {
  const int material = add_material(scene, {.name = "patch", .diffuse = glm::vec3(0), .emission = colour});
  add_object(scene, make_plane({.width = size.x, .depth = size.y}), material,
             upright({.name = "patch", .translation = {centre.x, centre.y, 0}}, 0));
}

/// All hues at four lightnesses, greys, and some colours of skin, leaves and sky; 0 to 1.
Scene chart() {
  Scene scene{.name = "chart"};
  scene.ambient = glm::vec3(0);
  scene.background = glm::vec3(0.18f);
  for (int column = 0; column < 12; ++column) {
    // The hues of a hexagon: each component is 1 for a third of the way round, 0 for another, and changes between.
    const auto part = [&](float peak) {
      const float away = std::abs(float(column) / 2 - peak);
      return std::clamp(2 - std::min(away, 6 - away), 0.0f, 1.0f);
    };
    const glm::vec3 pure(part(0), part(2), part(4));
    const std::array<glm::vec3, 4> rows = {glm::mix(pure, glm::vec3(1), 0.55f), pure, 0.45f * pure,
                                           glm::mix(0.4f * pure, glm::vec3(0.2f), 0.7f)};
    for (std::size_t row = 0; row < rows.size(); ++row)
      add_patch(scene, rows[row], {-2.75 + 0.5 * column, 1.6 - 0.7 * double(row)}, {0.5f, 0.7f});
  }
  for (int column = 0; column < 12; ++column)
    add_patch(scene, glm::vec3(float(column) / 11), {-2.75 + 0.5 * column, -1.15}, {0.5f, 0.6f});
  const std::array<glm::vec3, 6> things = {glm::vec3(0.56f, 0.31f, 0.21f), glm::vec3(0.78f, 0.52f, 0.41f),
                                           glm::vec3(0.11f, 0.2f, 0.05f),  glm::vec3(0.12f, 0.24f, 0.55f),
                                           glm::vec3(0.72f, 0.3f, 0.03f),  glm::vec3(0.35f, 0.06f, 0.12f)};
  for (std::size_t i = 0; i < things.size(); ++i) add_patch(scene, things[i], {-2.5 + double(i), -1.75}, {1, 0.6f});
  scene.camera = {.eye = {0, 0, 5}, .target = {0, 0, 0}, .projection = Projection::orthographic, .height = 4.6f};
  return scene;
}

/// Smooth gradients: a dark wall and a bright floor, lit from one side.
Scene ramp() {
  Scene scene{.name = "ramp"};
  scene.ambient = glm::vec3(0);
  const int dark = add_material(scene, {.name = "dark", .diffuse = {0.05f, 0.055f, 0.07f}});
  const int bright = add_material(scene, {.name = "bright", .diffuse = glm::vec3(0.6f)});
  add_object(scene, make_plane({.width = 8, .depth = 3}), dark,
             upright({.name = "wall", .translation = {0, 1.5, -1}}, 0));
  add_object(scene, make_plane({.width = 8, .depth = 3}), bright, {.name = "floor", .translation = {0, 0, 0.5}});
  add_object(scene, make_sphere({.radius = 0.6f}), bright, {.name = "ball", .translation = {0.9, 0.6, 0.1}});
  add_light(scene, {.position = {-3.2, 2.2, 1.2}, .colour = glm::vec3(4.5f)});
  scene.camera = {.eye = {0, 1.4, 5}, .target = {0, 1, 0}, .fov_y = degrees(40), .near = 0.5f, .far = 20};
  return scene;
}

/// An alley at night with lanterns that are much brighter than what a display shows.
Scene lanterns() {
  Scene scene{.name = "lanterns"};
  scene.ambient = {0.02f, 0.025f, 0.05f};
  scene.background = {0.01f, 0.015f, 0.04f};
  const int ground = add_material(
      scene,
      {.name = "paving",
       .diffuse_texture = add_texture(
           scene, "paving",
           make_checker({.size = 64, .squares = 2, .first = {0.4f, 0.4f, 0.42f, 1}, .second = {0.2f, 0.2f, 0.24f, 1}}),
           Filter::linear)});
  const int wall = add_material(scene, {.name = "wall", .diffuse = {0.35f, 0.25f, 0.2f}});
  const int copper = add_material(scene, metal("copper", copper_reflectance, 60));
  const int iron = add_material(scene, plastic("iron", glm::vec3(0.1f), 30));
  add_object(scene, make_plane({.width = 6, .depth = 20, .repeat = {3, 10}}), ground, {.name = "ground"});
  for (const double side : {-1.0, 1.0})
    add_object(scene, make_plane({.width = 20, .depth = 5}), wall,
               upright({.name = "wall", .translation = {side * 3, 2.5, 0}}, side < 0 ? degrees(90) : degrees(-90)));
  const std::array<glm::vec3, 4> colours = {glm::vec3(30, 16, 5), glm::vec3(24, 20, 14), glm::vec3(5, 14, 30),
                                            glm::vec3(28, 4, 3)};
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const double x = i % 2 == 0 ? -1.7 : 1.7, z = 1.5 - 2.2 * double(i);
    const int glow = add_material(scene, {.name = "glow", .diffuse = glm::vec3(0), .emission = colours[i]});
    add_object(scene, make_icosphere({.radius = 0.16f, .subdivisions = 3}), glow,
               {.name = "lantern", .translation = {x, 2.1, z}});
    add_object(scene, make_cylinder({.radius = 0.04f, .height = 1.9f}), iron,
               {.name = "post", .translation = {x, 0, z}});
    add_light(scene, {.position = {x, 2.1, z}, .colour = 0.12f * colours[i]});
  }
  add_object(scene, make_teapot({.height = 0.8f}), copper, {.name = "teapot", .translation = {0, 0, 0.2}});
  scene.camera = {.eye = {0, 1.6, 5.2}, .target = {0, 1.1, 0}, .fov_y = degrees(52), .near = 0.3f, .far = 60};
  return scene;
}

}  // namespace

const SceneTable& post_scenes() {
  static const SceneTable scenes = {
      {"lanterns", [](const Settings&) { return lanterns(); }},
      {"chart", [](const Settings&) { return chart(); }},
      {"ramp", [](const Settings&) { return ramp(); }},
      builtin_scene("room"),
  };
  return scenes;
}

}  // namespace atelier
