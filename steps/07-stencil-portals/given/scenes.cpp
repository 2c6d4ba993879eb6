#include "07-stencil-portals/given/scenes.hpp"

#include <memory>

#include "07-stencil-portals/given/bodies.hpp"
#include "07-stencil-portals/given/scene_parts.hpp"
#include "07-stencil-portals/given/scenes_through.hpp"
#include "scene/builder.hpp"
#include "scene/relief.hpp"
#include "scene/shapes.hpp"
#include "scene/sky.hpp"
#include "scene/textures.hpp"

namespace atelier {

namespace {

/// A warm room and a cool one, 40 m apart, joined by two doors. In the cool room a column stands behind the door,
/// between its plane and the virtual camera: it must not be seen.
Scene rooms() {
  Scene scene{.name = "rooms"};
  scene.ambient = glm::vec3(0.12f);
  const int warm = add_material(scene, {.name = "warm walls", .diffuse = {0.75f, 0.5f, 0.35f}});
  const int cool = add_material(scene, {.name = "cool walls", .diffuse = {0.35f, 0.5f, 0.75f}});
  const int tiles = checkered(scene, "tiles", {0.7f, 0.65f, 0.55f, 1}, {0.3f, 0.22f, 0.18f, 1});
  const int slate = checkered(scene, "slate", {0.5f, 0.55f, 0.6f, 1}, {0.12f, 0.15f, 0.2f, 1});
  const int copper = add_material(scene, metal("copper", copper_reflectance, 60));
  const int white = add_material(scene, plastic("white", glm::vec3(0.8f), 60));
  const Look look = add_look(scene, {0.8f, 0.65f, 0.2f});
  add_room(scene, 0, 0, {8, 4, 8}, warm, tiles);
  add_room(scene, 40, 0, {8, 4, 10}, cool, slate);
  const int here = add_door(scene, quarter_turned("door here", {0, 1.25, -2}, 0), look);
  const int there = add_door(scene, quarter_turned("door there", {41, 1.25, 1}, 3), look);  // faces -x
  join(scene, here, there, {0.02f, 0.03f, 0.05f});
  add_object(scene, make_box({.size = {0.6f, 0.6f, 0.6f}}), white,
             {.name = "box", .translation = {-0.9, 0.3, -1}, .rotation_angle = degrees(30)});
  add_object(scene, make_teapot({.height = 0.8f}), copper, {.name = "teapot", .translation = {38.5, 0, 1.4}});
  add_object(scene, make_sphere({.radius = 0.5f}), white, {.name = "ball", .translation = {37.5, 0.5, 0.2}});
  add_object(scene, make_box({.size = {0.5f, 3, 2.5f}}), copper,
             {.name = "behind the door", .translation = {42, 1.5, 1}});
  add_lamp(scene, {1.5, 3.4, 1.5}, {6, 5.4, 4.5});
  add_lamp(scene, {38, 3.4, -1.5}, {5, 5.5, 6});
  scene.camera = {.eye = {0.5, 1.5, 3}, .target = {0.25, 1.25, -2}, .fov_y = degrees(60), .near = 0.1f, .far = 60};
  return scene;
}

/// A hall between two doors that face each other: a corridor without end.
Scene corridor() {
  Scene scene{.name = "corridor"};
  scene.ambient = glm::vec3(0.15f);
  const int walls = add_material(scene, {.name = "walls", .diffuse = {0.6f, 0.6f, 0.52f}});
  const int tiles = checkered(scene, "tiles", {0.7f, 0.65f, 0.55f, 1}, {0.25f, 0.3f, 0.28f, 1});
  const int red = add_material(scene, plastic("red", {0.7f, 0.12f, 0.08f}, 60));
  const Look look = add_look(scene, {0.25f, 0.35f, 0.6f});
  add_room(scene, 0, 0, {5, 3.5f, 8}, walls, tiles);
  const int front = add_door(scene, quarter_turned("front door", {0, 1.25, -3}, 0), look);
  const int back = add_door(scene, quarter_turned("back door", {0, 1.25, 3}, 2), look);
  join(scene, front, back, {0.6f, 0.1f, 0.5f});
  add_object(scene, make_sphere({.radius = 0.3f}), red, {.name = "ball", .translation = {0.75, 0.3, -1.5}});
  add_lamp(scene, {-1, 2.8, 0}, glm::vec3(5));
  scene.camera = {
      .eye = {-0.375, 1.625, 1.5}, .target = {0.125, 1.125, -3}, .fov_y = degrees(65), .near = 0.1f, .far = 2000};
  return scene;
}

/// Two corridors without end that cross: a hall between two pairs of wide doors that face each other.
Scene crossing() {
  Scene scene{.name = "crossing"};
  scene.ambient = glm::vec3(0.15f);
  const int walls = add_material(scene, {.name = "walls", .diffuse = {0.6f, 0.6f, 0.52f}});
  const int tiles = checkered(scene, "tiles", {0.7f, 0.65f, 0.55f, 1}, {0.25f, 0.3f, 0.28f, 1});
  const int red = add_material(scene, plastic("red", {0.7f, 0.12f, 0.08f}, 60));
  const Look blue = add_look(scene, {0.25f, 0.35f, 0.6f}), brown = add_look(scene, {0.6f, 0.35f, 0.25f});
  constexpr float width = 4.5f;
  add_room(scene, 0, 0, {8, 3.5f, 8}, walls, tiles);
  const int front = add_door(scene, quarter_turned("front door", {0, 1.25, -3}, 0), blue, width);
  const int back = add_door(scene, quarter_turned("back door", {0, 1.25, 3}, 2), blue, width);
  const int left = add_door(scene, quarter_turned("left door", {-3, 1.25, 0}, 1), brown, width);
  const int right = add_door(scene, quarter_turned("right door", {3, 1.25, 0}, 3), brown, width);
  join(scene, front, back, {0.6f, 0.1f, 0.5f});
  join(scene, left, right, {0.1f, 0.5f, 0.6f});
  add_object(scene, make_sphere({.radius = 0.3f}), red, {.name = "ball", .translation = {1.5, 0.3, -1.5}});
  add_lamp(scene, {-0.75, 2.8, 0.75}, glm::vec3(5));
  scene.camera = {
      .eye = {1.25, 1.625, 1.25}, .target = {-1.25, 1.25, -1.25}, .fov_y = degrees(75), .near = 0.1f, .far = 2000};
  return scene;
}

/// The exit hangs tilted under a parent that is turned: what is seen through the door lies askew. The door itself is
/// turned by odd angles too.
Scene rolled() {
  Scene scene{.name = "rolled"};
  scene.ambient = glm::vec3(0.12f);
  scene.background = {0.25f, 0.35f, 0.5f};
  const int ground = checkered(scene, "ground", {0.45f, 0.5f, 0.35f, 1}, {0.25f, 0.32f, 0.2f, 1});
  const int sand = checkered(scene, "sand", {0.7f, 0.6f, 0.4f, 1}, {0.5f, 0.4f, 0.25f, 1});
  const int white = add_material(scene, plastic("white", glm::vec3(0.8f), 60));
  const int red = add_material(scene, plastic("red", {0.7f, 0.12f, 0.08f}, 60));
  const Look look = add_look(scene, {0.3f, 0.25f, 0.2f});
  add_object(scene, make_plane({.width = 16, .depth = 16, .repeat = {8, 8}}), ground, {.name = "ground"});
  add_object(scene, make_plane({.width = 16, .depth = 16, .repeat = {8, 8}}), sand,
             {.name = "sand", .translation = {60, 0, 0}});
  const int here =
      add_door(scene, {.name = "door", .translation = {-0.3, 1.3, -1.1}, .rotation_angle = degrees(23)}, look);
  const int mast = add_node(scene, {.name = "mast",
                                    .translation = {60, 1.45, 1},
                                    .rotation_axis = {0.06f, 1, 0.04f},
                                    .rotation_angle = degrees(172)});
  const int there = add_door(scene,
                             {.name = "tilted door",
                              .parent = mast,
                              .translation = {0.2, 0, 0.3},
                              .rotation_axis = {0, 0.15f, 1},
                              .rotation_angle = degrees(35)},
                             look);
  join(scene, here, there, {0.1f, 0.1f, 0.1f});
  add_object(scene, make_box({.size = {0.8f, 1.6f, 0.8f}}), red,
             {.name = "red box", .translation = {60, 0.8, -2.5}, .rotation_angle = degrees(20)});
  add_object(scene, make_sphere({.radius = 0.6f}), white, {.name = "ball", .translation = {59.2, 0.6, -2.2}});
  add_object(scene, make_cone({.radius = 0.5f, .height = 1.2f}), red, {.name = "cone", .translation = {1.6, 0, -2}});
  add_light(scene, {.type = LightType::directional,
                    .direction = {0.4f, -0.8f, -0.4f},
                    .colour = glm::vec3(0.8f),
                    .casts_shadow = false});
  scene.camera = {.eye = {0.6, 1.7, 3}, .target = {-0.2, 1.2, -1.1}, .fov_y = degrees(55), .near = 0.1f, .far = 100};
  return scene;
}

/// A mirror opposite a door: through the door the mirror is seen from the other side of the world, in the mirror the
/// door, and in that the mirror again.
Scene mirror() {
  Scene scene{.name = "mirror"};
  scene.ambient = glm::vec3(0.12f);
  const int walls = add_material(scene, {.name = "walls", .diffuse = {0.55f, 0.6f, 0.5f}});
  const int tiles = checkered(scene, "tiles", {0.7f, 0.65f, 0.55f, 1}, {0.3f, 0.22f, 0.18f, 1});
  const int copper = add_material(scene, metal("copper", copper_reflectance, 60));
  const int blue = add_material(scene, plastic("blue", {0.1f, 0.2f, 0.6f}, 60));
  const Look look = add_look(scene, {0.8f, 0.65f, 0.2f});
  add_room(scene, 0, 0, {9, 4, 9}, walls, tiles);
  const int glass = add_door(scene, {.name = "mirror", .translation = {-2.5, 1.5, -2.2}, .rotation_angle = degrees(38)},
                             look, 2.5f, 2);
  scene.portals.push_back({.node = glass, .colour = {0.4f, 0.4f, 0.45f}});
  const int door =
      add_door(scene, {.name = "door", .translation = {2.2, 1.3, -1.5}, .rotation_angle = degrees(-30)}, look);
  const int out =
      add_door(scene, {.name = "way out", .translation = {0.5, 1.3, 3.6}, .rotation_angle = degrees(170)}, look);
  join(scene, door, out, {0.05f, 0.05f, 0.1f});
  add_object(scene, make_teapot({.height = 0.9f}), copper,
             {.name = "teapot", .translation = {-0.5, 0, -0.9}, .rotation_angle = degrees(-40)});
  add_object(scene, make_box({.size = {0.4f, 1.2f, 0.4f}}), blue, {.name = "post", .translation = {0.7, 0.6, 0.4}});
  add_lamp(scene, {0.5, 3.5, 1}, glm::vec3(7));
  scene.camera = {.eye = {0.8, 1.7, 3.1}, .target = {0, 1.2, -1.5}, .fov_y = degrees(70), .near = 0.1f, .far = 60};
  return scene;
}

/// Two gates that are open from both sides, each in the open. The near one is seen from behind: through it one sees
/// what stands behind the far one, which is turned by an odd angle. A slab closely before that, and a ball closely
/// before the near one, must not be seen.
Scene gate() {
  Scene scene{.name = "gate"};
  scene.ambient = glm::vec3(0.12f);
  scene.background = {0.4f, 0.55f, 0.75f};
  const int meadow = checkered(scene, "meadow", {0.35f, 0.5f, 0.25f, 1}, {0.2f, 0.35f, 0.15f, 1});
  const int sand = checkered(scene, "sand", {0.7f, 0.6f, 0.4f, 1}, {0.5f, 0.4f, 0.25f, 1});
  const int copper = add_material(scene, metal("copper", copper_reflectance, 60));
  const int white = add_material(scene, plastic("white", glm::vec3(0.8f), 60));
  const int red = add_material(scene, plastic("red", {0.7f, 0.12f, 0.08f}, 60));
  const Look look = add_look(scene, {0.35f, 0.35f, 0.4f}, true);
  add_object(scene, make_plane({.width = 16, .depth = 16, .repeat = {8, 8}}), meadow, {.name = "meadow"});
  add_object(scene, make_plane({.width = 16, .depth = 16, .repeat = {8, 8}}), sand,
             {.name = "sand", .translation = {40, 0, 0}});
  const int near = add_door(scene, quarter_turned("near gate", {0.25, 1.25, -0.5}, 2), look);  // faces -z
  const int far =
      add_door(scene, {.name = "far gate", .translation = {40, 1.25, 0.5}, .rotation_angle = degrees(35)}, look);
  join(scene, near, far, {0.3f, 0.1f, 0.4f});
  add_object(scene, make_box({.size = {0.3f, 1, 0.3f}}), red, {.name = "post", .translation = {0, 0.5, 0.6}});
  add_object(scene, make_sphere({.radius = 0.4f}), white,
             {.name = "ball before the near gate", .translation = {0.5, 0.4, -1}});
  add_object(scene, make_cone({.radius = 0.5f, .height = 1.4f}), red, {.name = "cone", .translation = {2, 0, -2}});
  // In the frame of the far gate: z below 0 is behind it.
  add_object(scene, make_sphere({.radius = 0.3f}), white,
             {.name = "ball behind the far gate", .parent = far, .translation = {-0.25, -0.95, -0.45}});
  add_object(scene, make_teapot({.height = 0.8f}), copper,
             {.name = "teapot", .parent = far, .translation = {-0.3, -1.25, -2.2}});
  add_object(scene, make_box({.size = {1, 1.5f, 0.5f}}), copper,
             {.name = "slab before the far gate", .parent = far, .translation = {0.1, -0.5, 0.4}});
  add_light(scene, {.type = LightType::directional,
                    .direction = {0.4f, -0.8f, -0.4f},
                    .colour = glm::vec3(0.8f),
                    .casts_shadow = false});
  scene.camera = {.eye = {0.9, 1.6, 3.2}, .target = {0.1, 1.2, -0.5}, .fov_y = degrees(58), .near = 0.1f, .far = 100};
  return scene;
}

/// Dusk: the glow of the sun, which has set ahead on the left, and the moon above the end of the alley. Made once.
std::shared_ptr<const Sky> dusk() {
  static const std::shared_ptr<const Sky> sky = [] {
    SkyShape shape{.edge = 256,
                   .zenith = {0.045f, 0.06f, 0.17f},
                   .horizon = {0.3f, 0.17f, 0.17f},
                   .ground = {0.03f, 0.03f, 0.04f},
                   .clouds = 0.3f,
                   .cloud = {0.17f, 0.11f, 0.14f},
                   .stars = 0.05f,
                   .seed = 7};
    shape.discs = {{.direction = {-0.6f, -0.05f, -1}, .radius = 0, .halo = {0.5f, 0.18f, 0.06f}, .halo_width = 0.5f},
                   {.direction = {-0.13f, 0.36f, -1},
                    .colour = {0.95f, 0.9f, 0.78f},
                    .radius = 0.025f,
                    .halo = {0.1f, 0.09f, 0.09f},
                    .halo_width = 0.09f}};
    return std::make_shared<const Sky>(make_sky(shape));
  }();
  return sky;
}

/// An alley of brick walls at dusk. A door stands in its middle, another at its end on the side: the alley goes on in
/// itself. Copper lanterns.
Scene alley() {
  Scene scene{.name = "alley"};
  scene.ambient = {0.05f, 0.055f, 0.08f};
  scene.sky = dusk();
  const Material rough{.name = "bricks", .diffuse = glm::vec3(0.95f), .specular = glm::vec3(0.05f), .exponent = 20};
  const int bricks = add_relief(scene, rough, make_bricks({.size = 256, .columns = 3, .rows = 6}), true);
  const Material glazed{.name = "paving", .diffuse = glm::vec3(0.7f), .specular = glm::vec3(0.3f), .exponent = 80};
  const int paving = add_relief(scene, glazed, make_tiles({.size = 256}), true);
  const int copper = add_material(scene, metal("copper", copper_reflectance, 60));
  const int dark = add_material(scene, plastic("dark", glm::vec3(0.12f), 30));
  const Look look = add_look(scene, {0.5f, 0.3f, 0.2f});
  add_object(scene, make_plane({.width = 3, .depth = 16, .repeat = {3, 16}}), paving, {.name = "paving"});
  Mesh wall = make_plane({.width = 16, .depth = 4, .repeat = {8, 2}});
  add_object(scene, wall, bricks, upright({.name = "left wall", .translation = {-1.5, 2, 0}}, degrees(90)));
  add_object(scene, wall, bricks, upright({.name = "right wall", .translation = {1.5, 2, 0}}, degrees(-90)));
  add_object(scene, make_plane({.width = 3, .depth = 4, .repeat = {1.5f, 2}}), bricks,
             upright({.name = "end wall", .translation = {0, 2, -8}}, 0));
  add_object(scene, make_plane({.width = 3, .depth = 4, .repeat = {1.5f, 2}}), bricks,
             upright({.name = "near end", .translation = {0, 2, 8}}, degrees(180)));
  const int middle =
      add_door(scene, {.name = "door ahead", .translation = {-0.4, 1.3, -3.5}, .rotation_angle = degrees(15)}, look);
  const int side = add_door(
      scene, {.name = "door at the side", .translation = {1.3, 1.3, 4.5}, .rotation_angle = degrees(-80)}, look);
  join(scene, middle, side, {0.03f, 0.02f, 0.04f});
  for (const double z : {-6.0, -1.0, 3.0}) {
    add_object(scene, make_sphere({.radius = 0.16f}), copper, {.name = "lantern", .translation = {-1.1, 2.6, z}});
    add_object(scene, make_box({.size = {0.5f, 0.04f, 0.04f}}), dark, {.name = "arm", .translation = {-1.3, 2.8, z}});
    add_lamp(scene, {-0.8, 2.5, z}, {1.9f, 1.3f, 0.8f});
  }
  add_object(scene, make_teapot({.height = 0.5f}), copper, {.name = "teapot", .translation = {0.9, 0, -1.6}});
  scene.camera = {.eye = {0.5, 1.6, 2.2}, .target = {-0.2, 1.3, -3.5}, .fov_y = degrees(62), .near = 0.1f, .far = 60};
  return scene;
}

}  // namespace

std::vector<SettingSpec> portal_scene_settings() {
  return {
      {.name = "body.way",
       .fallback = 0.5,
       .low = 0,
       .high = 1,
       .help = "how far the body of the scene 'astride' has gone through the door: half of it at 0.5"},
      {.name = "particles.count", .fallback = 160, .low = 0, .high = 500, .help = "of the scene 'swirl'"},
      {.name = "particles.time", .fallback = 0.0, .low = 0, .high = 1, .help = "of the scene 'swirl': 1 is as 0 again"},
  };
}

const SceneTable& whole_portal_scenes() {
  static const SceneTable scenes = {
      {"rooms", [](const Settings&) { return rooms(); }},
      {"corridor", [](const Settings&) { return corridor(); }},
      {"crossing", [](const Settings&) { return crossing(); }},
      {"rolled", [](const Settings&) { return rolled(); }},
      {"mirror", [](const Settings&) { return mirror(); }},
      {"gate", [](const Settings&) { return gate(); }},
      {"alley", [](const Settings&) { return alley(); }},
      {"lamp", [](const Settings&) { return make_lamp_scene(); }},
      {"astride", [](const Settings& settings) { return make_astride_scene(settings.real("body.way")); }},
      {"swirl",
       [](const Settings& settings) {
         return make_swirl_scene(settings.integer("particles.count"), settings.real("particles.time"));
       }},
      builtin_scene("room"),
  };
  return scenes;
}

const SceneTable& portal_scenes() {
  static const SceneTable scenes =
      adjusted(whole_portal_scenes(), [](Scene& scene, const Settings&) { split_bodies(scene); });
  return scenes;
}

glm::dvec3 walk_of(const Scene& scene) {
  if (scene.name == "rooms") return {-0.5, 0, -6};
  if (scene.name == "rolled") return {-1.1, -0.2, -5};
  if (scene.name == "corridor") return {0, 0, -40};
  if (scene.name == "gate") return {-0.6, -0.1, -5.5};
  return glm::dvec3(0);
}

}  // namespace atelier
