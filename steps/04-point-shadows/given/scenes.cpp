#include "04-point-shadows/given/scenes.hpp"

#include <cmath>

#include "03-shadow-mapping/given/scenes.hpp"
#include "04-point-shadows/given/cube_room.hpp"
#include "04-point-shadows/given/studies.hpp"
#include "04-point-shadows/given/walls.hpp"
#include "scene/builder.hpp"
#include "scene/shapes.hpp"
#include "scene/textures.hpp"

namespace atelier {

namespace {

/// A point light in a cage in the middle of a room: each wall, floor and ceiling gets its own shadows, and the cage's
/// bars cross the cube's edges.
Scene lantern(const Settings& settings) {
  Scene scene{.name = "lantern"};
  scene.ambient = glm::vec3(0.07f);
  const int paint = add_material(scene, {.name = "paint", .diffuse = {0.66f, 0.64f, 0.6f}}),
            iron = add_material(scene, {.name = "iron", .diffuse = {0.25f, 0.22f, 0.2f}, .two_sided = true});
  add_walls(scene, {.distance = 3, .side = 6, .material = paint});
  const int bar = add_mesh(scene, make_box({.size = {0.08f, 1.3f, 0.08f}})),
            ball = add_mesh(scene, make_sphere({.radius = 0.16f}));
  const auto put = [&](const char* name, int mesh, const glm::dvec3& at, const glm::vec3& axis, double angle) {
    add_node(scene, {.name = name,
                     .translation = at,
                     .rotation_axis = axis,
                     .rotation_angle = degrees(angle),
                     .mesh = mesh,
                     .material = iron});
  };
  // Twelve bars along the edges of a cube, a ball on each face, none of them symmetric enough to hide a swapped axis.
  for (const double a : {-0.61, 0.61})
    for (const double b : {-0.61, 0.61}) {
      put("bar", bar, {a, 0, b}, {0, 1, 0}, 0);
      put("bar", bar, {a, b, 0}, {1, 0, 0}, 90);
      put("bar", bar, {0, a, b}, {0, 0, 1}, 90);
    }
  put("ball", ball, {0.9, 0.25, 0.1}, {0, 1, 0}, 0);
  put("ball", ball, {-0.9, -0.2, 0.3}, {0, 1, 0}, 0);
  put("ball", ball, {0.2, 0.9, 0.3}, {0, 1, 0}, 0);
  put("ball", ball, {-0.3, -0.9, -0.15}, {0, 1, 0}, 0);
  put("ball", ball, {0.25, -0.3, 0.9}, {0, 1, 0}, 0);
  put("ball", ball, {-0.2, 0.15, -0.9}, {0, 1, 0}, 0);
  add_light(scene, {.name = "lamp", .position = {0, 0, 0}, .colour = glm::vec3(7)});
  scene.camera = {.eye = {0, 0.4, 2.95}, .target = {0, 0, 0}, .fov_y = degrees(88), .near = 0.05f, .far = 20};
  const double turn = double(degrees(settings.real("view.turn")));
  const glm::dvec3 eye = scene.camera.eye;
  scene.camera.eye = {eye.z * std::sin(turn), eye.y, eye.z * std::cos(turn)};
  return scene;
}

/// Boxes of many sizes in a room, with one point light off its centre.
Scene crates() {
  Scene scene{.name = "crates"};
  scene.ambient = glm::vec3(0.06f);
  const int wood = add_texture(scene, "wood", make_wood({.size = 256}));
  const int board = add_material(scene, {.name = "board", .diffuse = glm::vec3(0.9f), .diffuse_texture = wood}),
            wall = add_material(scene, {.name = "wall", .diffuse = {0.55f, 0.5f, 0.45f}});
  add_walls(scene, {.distance = 4, .side = 8, .material = wall});
  const int box = add_mesh(scene, make_box({.size = glm::vec3(1)}));
  struct Crate {
    glm::dvec3 at;
    float size, turn;
  };
  for (const Crate& crate : {Crate{{-1.8, -3.4, -1.4}, 1.2f, 20},
                             {{1.6, -3.5, -2.2}, 1.0f, 50},
                             {{2.4, -1.0, 0.6}, 0.8f, 15},
                             {{-2.3, 0.8, -2.2}, 0.9f, 35},
                             {{0.3, 2.3, -1.3}, 0.7f, 60}})
    add_node(scene, {.name = "crate",
                     .translation = crate.at,
                     .rotation_axis = {0.3f, 1, 0.2f},
                     .rotation_angle = degrees(double(crate.turn)),
                     .scale = glm::vec3(crate.size),
                     .mesh = box,
                     .material = board});
  add_light(scene, {.name = "lamp", .position = {0.3, 0.2, 0.4}, .colour = glm::vec3(11)});
  scene.camera = {.eye = {0, 0, 3.9}, .target = {0, -0.3, 0}, .fov_y = degrees(80), .near = 0.05f, .far = 20};
  return scene;
}

/// A point light high above a still life: all casters fit into one cone.
Scene desk() {
  Scene scene{.name = "desk"};
  scene.ambient = glm::vec3(0.07f);
  const int wood = add_texture(scene, "wood", make_wood({.size = 256}));
  const int top = add_material(scene, {.name = "top", .diffuse = glm::vec3(0.9f), .diffuse_texture = wood}),
            glaze = add_material(scene, plastic("glaze", {0.65f, 0.2f, 0.1f}, 100)),
            copper = add_material(scene, metal("copper", copper_reflectance, 80));
  add_object(scene, make_plane({.width = 7, .depth = 5, .repeat = {2, 2}}), top,
             {.name = "top", .casts_shadow = false});
  add_object(scene, make_teapot({.height = 0.8f, .subdivisions = 12}), glaze,
             {.name = "teapot", .rotation_angle = degrees(-30)});
  add_object(scene, make_torus({.ring_radius = 0.35f, .tube_radius = 0.1f}), copper,
             {.name = "ring", .translation = {1.2, 0.1, 0.5}});
  add_light(scene, {.name = "lamp", .position = {-1.1, 2.6, 0.9}, .colour = glm::vec3(7)});
  scene.camera = {.eye = {0.5, 1.9, 3.8}, .target = {0.2, 0.3, 0}, .fov_y = degrees(40), .near = 0.3f, .far = 20};
  return scene;
}

/// Extreme inputs: a point light on the floor, one inside a closed box, one among objects that cast no shadow, one with
/// casters on only one side.
Scene touching() {
  Scene scene{.name = "touching"};
  scene.ambient = glm::vec3(0.08f);
  const int grey = add_material(scene, {.name = "grey", .diffuse = glm::vec3(0.6f)}),
            clay = add_material(scene, {.name = "clay", .diffuse = {0.6f, 0.35f, 0.25f}});
  add_object(scene, make_plane({.width = 10, .depth = 8}), grey, {.name = "floor"});
  add_object(scene, make_box({.size = glm::vec3(0.6f)}), clay, {.name = "closed", .translation = {-1.6, 0.3, 0}});
  add_object(scene, make_box({.size = {0.3f, 1.2f, 0.3f}}), clay, {.name = "post", .translation = {0.9, 0.6, 0.2}});
  add_object(scene, make_sphere({.radius = 0.3f}), clay,
             {.name = "ghost", .translation = {2.4, 0.3, -0.6}, .casts_shadow = false});
  add_light(scene, {.name = "on the floor", .position = {0, 0, 0.6}, .colour = {0.5f, 0.45f, 0.3f}});
  add_light(scene, {.name = "in the box", .position = {-1.6, 0.3, 0}, .colour = {3, 0.3f, 0.3f}});
  add_light(scene, {.name = "above", .position = {2.2, 2.4, 0.8}, .colour = {2.0f, 2.2f, 2.6f}});
  scene.camera = {.eye = {0.3, 2.6, 5}, .target = {0.2, 0.3, 0}, .fov_y = degrees(45), .near = 0.3f, .far = 20};
  return scene;
}

void adjust(Scene& scene, const Settings& settings) {
  choose_casters(scene, settings);
  if (const double scale = settings.real("scene.scale"); scale != 1) enlarge(scene, scale);
}

}  // namespace

const SceneTable& point_scenes() {
  static const SceneTable scenes = adjusted(
      {
          builtin_scene("room"),
          {"lantern", lantern},
          {"crates", [](const Settings&) { return crates(); }},
          {"desk", [](const Settings&) { return desk(); }},
          {"touching", [](const Settings&) { return touching(); }},
          {"dots", dots},
          {"bare-walls", [](const Settings&) { return bare_walls(); }},
          {"boards", [](const Settings&) { return boards(); }},
          {"cube-room", [](const Settings&) { return make_cube_room_scene(); }},
      },
      adjust);
  return scenes;
}

std::vector<SettingSpec> point_scene_settings() {
  return {
      {.name = "view.turn",
       .fallback = 0.0,
       .low = -360,
       .high = 360,
       .help = "of the scene 'lantern': degrees by which the camera is rotated about the vertical axis"},
      scale_setting(),
      casters_setting(),
  };
}

}  // namespace atelier
