#include "02-blinn-phong/given/scenes.hpp"

#include "02-blinn-phong/blinn_phong.hpp"
#include "02-blinn-phong/given/studies.hpp"
#include "scene/builder.hpp"
#include "scene/shapes.hpp"
#include "scene/textures.hpp"

namespace atelier {

namespace {

/// One low-poly ball under one light: facets wide enough that an interpolated normal is visibly too short.
Scene facets() {
  Scene scene{.name = "facets"};
  scene.ambient = glm::vec3(0.04f);
  scene.background = {0.03f, 0.03f, 0.04f};
  Mesh ball = make_sphere({.radius = 1, .segments = 8, .rings = 5});
  add_object(scene, ball, add_material(scene, plastic("red", {0.7f, 0.12f, 0.1f}, 48)), {.name = "ball"});
  add_light(scene, {.type = LightType::point, .position = {1.6, 2.2, 2.4}, .colour = glm::vec3(11)});
  scene.camera = {.eye = {0, 0.6, 3.6}, .target = {0, 0, 0}, .fov_y = degrees(40), .near = 0.5f, .far = 20};
  return scene;
}

/// A torus with a light behind it: what is lit from behind must stay dark, highlights included.
Scene backlight() {
  Scene scene{.name = "backlight"};
  scene.ambient = glm::vec3(0.02f);
  const int glaze = add_material(
      scene, {.name = "glaze", .diffuse = {0.1f, 0.25f, 0.45f}, .specular = glm::vec3(0.8f), .exponent = 4});
  add_object(scene, make_torus({}), glaze, {.name = "ring", .rotation_axis = {1, 0, 0}, .rotation_angle = degrees(70)});
  add_light(scene, {.type = LightType::directional, .direction = {0.5f, -0.35f, 1.0f}, .colour = glm::vec3(1.2f)});
  add_light(scene, {.type = LightType::directional, .direction = {0.8f, -0.6f, -0.4f}, .colour = glm::vec3(0.5f)});
  scene.camera = {.eye = {0, 0.8, 3.2}, .target = {0, 0, 0}, .fov_y = degrees(40), .near = 0.5f, .far = 20};
  return scene;
}

/// Two spot lights over a floor: one with a soft rim, one whose inner cone is its outer cone.
Scene spots() {
  Scene scene{.name = "spots"};
  scene.ambient = glm::vec3(0.02f);
  const int floor = add_material(scene, {.name = "floor", .diffuse = glm::vec3(0.75f)});
  const int knob = add_material(scene, plastic("knob", {0.6f, 0.55f, 0.5f}, 80));
  add_object(scene, make_plane({.width = 9, .depth = 7}), floor, {.name = "floor"});
  add_object(scene, make_sphere({.radius = 0.5f}), knob, {.name = "knob", .translation = {0, 0.5, 0.4}});
  add_light(scene, {.type = LightType::spot,
                    .position = {-2.6, 3, 0.8},
                    .direction = {0.45f, -1, -0.2f},
                    .colour = {9, 6.5f, 3},
                    .inner_angle = degrees(14),
                    .outer_angle = degrees(27)});
  add_light(scene, {.type = LightType::spot,
                    .position = {2.4, 3, 1},
                    .direction = {-0.25f, -1, -0.3f},
                    .colour = {3, 6, 9},
                    .inner_angle = degrees(22),
                    .outer_angle = degrees(22)});
  scene.camera = {.eye = {0, 3.2, 6.2}, .target = {0, 0.1, 0}, .fov_y = degrees(45), .near = 0.5f, .far = 30};
  return scene;
}

/// A floor with oriented textures, seen at an angle in daylight: wrap, filter, decoding.
Scene tiles() {
  Scene scene{.name = "tiles"};
  scene.background = {0.35f, 0.45f, 0.6f};
  scene.ambient = glm::vec3(0.25f);
  const int grid = add_texture(scene, "uv grid", make_uv_grid(256), Filter::mipmap, Wrap::repeat);
  const int wood = add_texture(scene, "wood", make_wood({.size = 256}), Filter::mipmap, Wrap::mirrored_repeat);
  Material floor{.name = "floor", .diffuse = glm::vec3(1)}, crate{.name = "crate", .diffuse = glm::vec3(1)};
  floor.diffuse_texture = grid;
  crate.diffuse_texture = wood;
  add_object(scene, make_plane({.width = 24, .depth = 24, .repeat = {8, 8}}), add_material(scene, floor),
             {.name = "floor"});
  add_object(scene, make_box({.size = glm::vec3(1.2f)}), add_material(scene, crate),
             {.name = "crate", .translation = {0.8, 0.6, 1.5}, .rotation_angle = degrees(30)});
  add_light(scene, {.type = LightType::directional, .direction = {-0.4f, -1, -0.5f}, .colour = glm::vec3(0.7f)});
  scene.camera = {.eye = {-1, 1.6, 5.2}, .target = {0.3, 0.5, 0}, .fov_y = degrees(50), .near = 0.2f, .far = 60};
  return scene;
}

/// 64 small lights of all colours over a floor with knobs.
Scene festival() {
  Scene scene{.name = "festival"};
  scene.ambient = glm::vec3(0.01f);
  add_object(scene, make_plane({.width = 10, .depth = 10}), add_material(scene, plastic("floor", glm::vec3(0.45f), 40)),
             {.name = "floor"});
  const int knob = add_material(scene, plastic("knob", glm::vec3(0.7f), 90));
  for (int i = 0; i < 9; ++i)
    add_object(scene, make_sphere({.radius = 0.4f}), knob,
               {.name = "knob", .translation = {(i % 3 - 1) * 2.4, 0.4, (i / 3 - 1) * 2.4}});
  for (int i = 0; i < 64; ++i) {
    const double x = (i % 8 - 3.5) * 1.15, z = (i / 8 - 3.5) * 1.15;
    const float hue = float(i) * 0.7f;
    add_light(scene,
              {.type = LightType::point,
               .position = {x, 0.55 + 0.25 * (i % 3), z},
               .colour = 0.11f * (glm::vec3(1) + glm::vec3(std::cos(hue), std::cos(hue - 2.1f), std::cos(hue + 2.1f))),
               .attenuation = {0.05f, 0, 1}});
  }
  scene.camera = {.eye = {0, 5.5, 7.2}, .target = {0, 0, 0.3}, .fov_y = degrees(45), .near = 0.5f, .far = 30};
  return scene;
}

/// Extreme inputs: a light on the surface, a light at the eye, a black and an over-bright material, a needle, a box
/// without normals, spots of 0 and 180 degrees.
Scene edges() {
  Scene scene{.name = "edges"};
  scene.ambient = glm::vec3(0.05f);
  const int white = add_material(scene, plastic("white", glm::vec3(0.6f), 20)),
            black = add_material(scene, {.name = "black", .diffuse = glm::vec3(0)}),
            glow = add_material(scene, {.name = "glow", .diffuse = glm::vec3(0.2f), .emission = {1.5f, 0.6f, 0.2f}});
  add_object(scene, make_plane({.width = 6, .depth = 6}), white, {.name = "floor"});
  add_object(scene, make_sphere({.radius = 0.5f}), black, {.name = "black", .translation = {-1.3, 0.5, 0}});
  add_object(scene, make_sphere({.radius = 0.5f}), glow, {.name = "glow", .translation = {0, 0.5, 0}});
  add_object(scene, make_sphere({.radius = 0.5f}), white,
             {.name = "needle", .translation = {1.3, 0.5, 0}, .scale = {0.02f, 1.4f, 0.02f}});
  Mesh blind = make_box({.size = glm::vec3(0.6f)});
  for (Vertex& vertex : blind.vertices) vertex.normal = glm::vec3(0);
  add_object(scene, blind, white, {.name = "no normals", .translation = {2.2, 0.3, 0.6}});
  scene.camera = {.eye = {0, 2.2, 5}, .target = {0, 0.3, 0}, .fov_y = degrees(45), .near = 0.2f, .far = 30};
  add_light(scene, {.type = LightType::point, .position = {0.8, 0, 1.2}, .colour = glm::vec3(0.3f)});
  add_light(scene, {.type = LightType::point, .position = scene.camera.eye, .colour = glm::vec3(6)});
  add_light(scene, {.type = LightType::spot,
                    .position = {-2, 2, 1},
                    .direction = {0, -1, 0},
                    .colour = glm::vec3(50),
                    .inner_angle = 0,
                    .outer_angle = 0});
  add_light(scene, {.type = LightType::spot,
                    .position = {2, 2, -1.5},
                    .direction = {0, 1, 0},
                    .colour = {1.2f, 1.6f, 2.4f},
                    .inner_angle = degrees(180),
                    .outer_angle = degrees(180)});
  return scene;
}

/// A bollard under a point light, and sixty lights across the water that are too far away to be visible, a spot light
/// that points away, and a light that is off.
Scene quay() {
  Scene scene{.name = "quay"};
  scene.ambient = glm::vec3(0.005f);
  const int stone = add_material(scene, {.name = "stone", .diffuse = glm::vec3(0.4f)});
  const int iron = add_material(scene, plastic("iron", glm::vec3(0.08f), 60));
  add_object(scene, make_plane({.width = 8, .depth = 6}), stone, {.name = "quay"});
  add_object(scene, make_cylinder({.radius = 0.3f, .height = 0.7f}), iron, {.name = "bollard"});
  add_object(scene, make_torus({.ring_radius = 0.34f, .tube_radius = 0.07f}), iron,
             {.name = "rope", .translation = {0, 0.3, 0}});
  add_light(scene, {.name = "lamp", .position = {1.2, 2.5, 1}, .colour = {6, 4.5f, 2.5f}});
  for (int i = 0; i < 60; ++i)
    add_light(
        scene,
        {.name = "lantern", .position = {10.0 * i - 300, 4, -450.0 - 7 * (i % 5)}, .colour = {0.5f, 0.35f, 0.15f}});
  add_light(scene, {.type = LightType::spot,
                    .name = "searchlight",
                    .position = {-6, 3, -20},
                    .direction = {-0.2f, 0.3f, -1},
                    .colour = glm::vec3(200),
                    .inner_angle = degrees(4),
                    .outer_angle = degrees(6)});
  add_light(scene, {.name = "out", .position = {-2, 2, 0}, .colour = glm::vec3(0)});
  scene.camera = {.eye = {1.5, 1.7, 3.4}, .target = {0, 0.3, 0}, .fov_y = degrees(45), .near = 0.5f, .far = 30};
  return scene;
}

/// Two lights of each type over a floor, for "light.blind": no object reaches up to a blind, and all materials are
/// matt, so that no highlight can be wrong. One of two equal balls receives no shadow, and so no stripes.
Scene blinds() {
  Scene scene{.name = "blinds"};
  scene.ambient = glm::vec3(0.06f);
  const int floor = add_material(scene, {.name = "floor", .diffuse = glm::vec3(0.75f)});
  const int ivory = add_material(scene, {.name = "ivory", .diffuse = {0.8f, 0.76f, 0.66f}});
  add_object(scene, make_plane({.width = 12, .depth = 9}), floor, {.name = "floor"});
  add_object(scene, make_sphere({.radius = 0.55f}), ivory, {.name = "striped", .translation = {-0.9, 0.55, 0.7}});
  add_object(scene, make_sphere({.radius = 0.55f}), ivory,
             {.name = "plain", .translation = {0.9, 0.55, 0.7}, .receives_shadow = false});
  const auto spot = [&](const char* name, double x, const glm::vec3& colour) {
    add_light(scene, {.type = LightType::spot,
                      .name = name,
                      .position = {x, 3, 0.6},
                      .direction = {float(-0.25 * x), -1, -0.1f},
                      .colour = colour,
                      .inner_angle = degrees(30),
                      .outer_angle = degrees(38)});
  };
  spot("warm spot", -1.9, {4, 1.8f, 0.5f});
  spot("cool spot", 1.9, {0.5f, 1.8f, 4});
  add_light(scene, {.name = "green lamp", .position = {-2.3, 2, -1.5}, .colour = {0.3f, 2.2f, 0.5f}});
  add_light(scene, {.name = "pink lamp", .position = {2.5, 2, -1.5}, .colour = {2.2f, 0.3f, 1.1f}});
  add_light(scene, {.type = LightType::directional, .direction = {0.5f, -1, -0.3f}, .colour = {0.16f, 0.12f, 0.05f}});
  add_light(scene, {.type = LightType::directional, .direction = {-0.73f, -1, 0.2f}, .colour = {0.05f, 0.1f, 0.2f}});
  scene.camera = {.eye = {0, 4.6, 5.6}, .target = {0, 0.1, 0}, .fov_y = degrees(42), .near = 0.5f, .far = 30};
  return scene;
}

/// The setting material.exponent; if it is -1, the default exponent.
float asked_exponent(const Settings& settings) {
  const double asked = settings.real("material.exponent");
  return asked >= 0 ? float(asked) : Material().exponent;
}

}  // namespace

std::vector<SettingSpec> blinn_phong_scene_settings() {
  return {
      {.name = "material.exponent",
       .fallback = -1.0,
       .low = -1,
       .high = 1e6,
       .help = "the exponent of every material; -1: its own"},
      {.name = "material.balance",
       .fallback = false,
       .help = "scale materials so that diffuse and specular colour together are at most 1"},
      {.name = "plate.cells",
       .fallback = 32,
       .low = 1,
       .high = 512,
       .help = "squares along a side of the scene 'plate'"},
  };
}

void adjust_materials(Scene& scene, const Settings& settings) {
  for (Material& material : scene.materials) {
    if (const double exponent = settings.real("material.exponent"); exponent >= 0) material.exponent = float(exponent);
    if (settings.flag("material.balance")) blinn_phong::balance(material.diffuse, material.specular);
  }
}

const SceneTable& unadjusted_blinn_phong_scenes() {
  static const SceneTable scenes = {
      builtin_scene("teapot"),
      builtin_scene("sphere"),
      builtin_scene("materials"),
      builtin_scene("lights"),
      {"facets", [](const Settings&) { return facets(); }},
      {"backlight", [](const Settings&) { return backlight(); }},
      {"spots", [](const Settings&) { return spots(); }},
      {"tiles", [](const Settings&) { return tiles(); }},
      {"festival", [](const Settings&) { return festival(); }},
      {"edges", [](const Settings&) { return edges(); }},
      {"quay", [](const Settings&) { return quay(); }},
      {"blinds", [](const Settings&) { return blinds(); }},
      builtin_scene("room"),
      builtin_scene("hall"),
      {"furnace", [](const Settings&) { return furnace(); }},
      {"highlight", [](const Settings& settings) { return highlight(asked_exponent(settings)); }},
      {"plate", plate},
      builtin_scene("primitives"),
      builtin_scene("robot"),
  };
  return scenes;
}

const SceneTable& blinn_phong_scenes() {
  static const SceneTable scenes = adjusted(unadjusted_blinn_phong_scenes(), adjust_materials);
  return scenes;
}

}  // namespace atelier
