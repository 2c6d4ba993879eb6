#include "03-shadow-mapping/given/scenes.hpp"

#include <cmath>

#include "03-shadow-mapping/given/three_cubes.hpp"
#include "scene/builder.hpp"
#include "scene/builtin.hpp"
#include "scene/shapes.hpp"
#include "scene/textures.hpp"

namespace atelier {

namespace {

/// A spot at `position` towards `target`, with a soft cone of `outer` degrees from its axis; its light has `colour` at
/// the target.
Light spot_at(const std::string& name, const glm::dvec3& position, const glm::dvec3& target, double outer,
              const glm::vec3& colour) {
  const glm::dvec3 way = target - position;
  return {.type = LightType::spot,
          .name = name,
          .position = position,
          .direction = glm::vec3(glm::normalize(way)),
          .colour = colour * float(glm::dot(way, way)),
          .inner_angle = degrees(outer * 0.8),
          .outer_angle = degrees(outer)};
}

Light directional_along(const glm::vec3& direction, const glm::vec3& colour) {
  return {.type = LightType::directional, .name = "sun", .direction = direction, .colour = colour};
}

/// A floor that casts no shadow, since nothing is below it.
void add_floor(Scene& scene, float side, const glm::vec3& colour) {
  const int material = add_material(scene, {.name = "floor", .diffuse = colour});
  add_object(scene, make_plane({.width = side, .depth = side}), material, {.name = "floor", .casts_shadow = false});
}

}  // namespace

Scene make_teapot_scene() {
  Scene scene{.name = "teapot"};
  scene.ambient = glm::vec3(0.08f);
  const int wood = add_texture(scene, "wood", make_wood({.size = 256}));
  const int table = add_material(scene, {.name = "table", .diffuse = glm::vec3(0.9f), .diffuse_texture = wood}),
            plaster = add_material(scene, {.name = "plaster", .diffuse = {0.6f, 0.62f, 0.6f}}),
            glaze = add_material(scene, plastic("glaze", {0.1f, 0.35f, 0.5f}, 100));
  add_object(scene, make_plane({.width = 8, .depth = 6, .repeat = {2, 2}}), table,
             {.name = "table", .translation = {0, 0, 0.5}, .casts_shadow = false});
  add_object(scene, make_plane({.width = 8, .depth = 5}), plaster,
             upright({.name = "wall", .translation = {0, 2.5, -1.6}, .casts_shadow = false}, 0));
  add_object(scene, make_teapot({.height = 1, .subdivisions = 16}), glaze,
             {.name = "teapot", .rotation_angle = degrees(25)});
  add_light(scene, spot_at("lamp", {2.3, 1.9, 3.4}, {0, 0.6, 0}, 40, glm::vec3(1.1f)));
  scene.camera = {.eye = {-0.6, 1.7, 4.6}, .target = {-0.1, 0.75, 0}, .fov_y = degrees(40), .near = 0.5f, .far = 20};
  return scene;
}

namespace {

/// Rotates a scene and its camera about an axis through the origin, with an additional root node. Lights are not
/// rotated.
void roll(Scene& scene, const glm::vec3& axis, float angle) {
  Node all{.name = "all", .rotation_axis = axis, .rotation_angle = angle};
  const glm::dmat3 turn(world_matrices_exact({all})[0]);
  const int root = add_node(scene, std::move(all));
  for (int i = 0; i < root; ++i)
    if (scene.nodes[std::size_t(i)].parent < 0) scene.nodes[std::size_t(i)].parent = root;
  scene.camera.eye = turn * scene.camera.eye;
  scene.camera.target = turn * scene.camera.target;
  scene.camera.up = glm::vec3(turn * glm::dvec3(scene.camera.up));
}

/// A wide floor under a low directional light, and one post: shows self-shadowing. The map's up is the world's up, so
/// its texels lie in rows along the floor. grazing.roll rotates everything except the light about the light's
/// direction: the picture is the same, but rotated in the map.
Scene grazing(const Settings& settings) {
  Scene scene{.name = "grazing"};
  scene.ambient = glm::vec3(0.1f);
  add_floor(scene, 20, glm::vec3(0.7f));
  scene.nodes.back().casts_shadow = true;  // this scene shows acne
  const int stone = add_material(scene, {.name = "stone", .diffuse = {0.5f, 0.42f, 0.35f}});
  add_object(scene, make_box({.size = {0.5f, 1, 0.5f}}), stone, {.name = "post", .translation = {0, 0.5, 0}});
  const double height = double(degrees(90 - settings.real("grazing.angle")));  // above the horizon
  const glm::vec3 direction(-float(std::cos(height)), -float(std::sin(height)), -0.3f * float(std::cos(height)));
  add_light(scene, directional_along(direction, glm::vec3(float(0.9 / std::max(std::sin(height), 0.05)))));
  scene.camera = {.eye = {0.8, 2.2, 6}, .target = {-0.6, 0.2, 0}, .fov_y = degrees(42), .near = 0.5f, .far = 40};
  if (const double angle = settings.real("grazing.roll"); angle != 0) roll(scene, direction, degrees(angle));
  return scene;
}

/// A table with four legs on a floor: shadows must begin at the legs.
Scene table() {
  Scene scene{.name = "table"};
  scene.ambient = glm::vec3(0.08f);
  add_floor(scene, 8, {0.65f, 0.6f, 0.55f});
  const int wood = add_material(scene, plastic("wood", {0.42f, 0.22f, 0.1f}, 30)),
            brass = add_material(scene, metal("brass", {0.9f, 0.75f, 0.4f}, 60));
  const int leg = add_mesh(scene, make_box({.size = {0.07f, 0.72f, 0.07f}}));
  add_object(scene, make_box({.size = {1.5f, 0.05f, 0.9f}}), wood, {.name = "top", .translation = {0, 0.745, 0}});
  for (const double x : {-0.68, 0.68})
    for (const double z : {-0.38, 0.38})
      add_node(scene, {.name = "leg", .translation = {x, 0.36, z}, .mesh = leg, .material = wood});
  add_object(scene, make_sphere({.radius = 0.16f}), brass, {.name = "ball", .translation = {0.3, 0.93, 0.1}});
  add_light(scene, spot_at("lamp", {1.6, 3.2, 1.9}, {0, 0.4, 0}, 35, glm::vec3(1.0f)));
  scene.camera = {.eye = {-1.6, 1.5, 2.6}, .target = {-0.1, 0.35, 0}, .fov_y = degrees(38), .near = 0.3f, .far = 20};
  return scene;
}

/// The robot under a white, a yellow and a red spot: three maps, three shadows, each of which removes only its own
/// colour.
Scene three_spots() {
  Scene scene = make_builtin_scene("robot");
  scene.name = "three-spots";
  for (Node& node : scene.nodes)
    if (node.name == "ground") node.casts_shadow = false;  // nothing lies below it
  scene.lights.clear();
  scene.ambient = glm::vec3(0.05f);
  add_light(scene, spot_at("white", {0.3, 4.2, 3.4}, {0, 0.9, 0}, 32, glm::vec3(0.55f)));
  add_light(scene, spot_at("yellow", {-3.4, 3.3, 1.6}, {0, 0.9, 0}, 32, {0.6f, 0.5f, 0.05f}));
  add_light(scene, spot_at("red", {3.3, 3.1, 1.2}, {0, 0.9, 0}, 32, {0.65f, 0.06f, 0.03f}));
  return scene;
}

/// A board over a floor under a light with an extent: the width of its penumbra can be computed. The light is
/// `penumbra.light` metres above the floor, the board `penumbra.board` metres. The edge of its shadow runs through the
/// origin, straight below the light, and along z unless the board is rotated. A second board may be above the same
/// edge: two penumbrae in one place.
Scene penumbra(const Settings& settings) {
  Scene scene{.name = "penumbra"};
  scene.ambient = glm::vec3(0.02f);
  add_floor(scene, 6, glm::vec3(0.75f));
  const int black = add_material(scene, {.name = "board", .diffuse = glm::vec3(0.15f)});
  const int board = add_mesh(scene, make_box({.size = {1.2f, 0.01f, 1.2f}}));
  const double turn = double(degrees(settings.real("penumbra.turn")));
  const auto hang = [&](double height) {
    add_node(scene, {.name = "board",
                     .translation = {-0.6 * std::cos(turn), height, 0.6 * std::sin(turn)},
                     .rotation_angle = float(turn),
                     .mesh = board,
                     .material = black});
  };
  hang(settings.real("penumbra.board"));
  if (const double second = settings.real("penumbra.second"); second > 0) hang(second);
  add_light(scene, spot_at("lamp", {0, settings.real("penumbra.light"), 0}, {0, 0, 0}, 40, glm::vec3(1)));
  scene.camera = {.eye = {0, 1.5, 4.5}, .target = {0, 0.2, 0}, .fov_y = degrees(35), .near = 0.5f, .far = 20};
  return scene;
}

/// A row of columns under a directional light, so long that one map for all of it is too coarse.
Scene colonnade() {
  Scene scene{.name = "colonnade"};
  scene.ambient = {0.12f, 0.14f, 0.18f};
  scene.background = {0.35f, 0.5f, 0.75f};
  const int marble = add_material(scene, plastic("marble", {0.72f, 0.7f, 0.66f}, 40)),
            ground = add_material(scene, {.name = "ground", .diffuse = {0.5f, 0.46f, 0.38f}});
  add_object(scene, make_plane({.width = 60, .depth = 60}), ground, {.name = "ground", .casts_shadow = false});
  const int column = add_mesh(scene, make_cylinder({.radius = 0.28f, .height = 3})),
            slab = add_mesh(scene, make_box({.size = {0.8f, 0.2f, 0.8f}})),
            beam = add_mesh(scene, make_box({.size = {0.7f, 0.3f, 1.8f}}));
  for (int i = 0; i < 14; ++i)
    for (const double x : {-1.6, 1.6}) {
      const double z = 3 - 1.8 * i;
      add_node(scene, {.name = "column", .translation = {x, 0.2, z}, .mesh = column, .material = marble});
      add_node(scene, {.name = "base", .translation = {x, 0.1, z}, .mesh = slab, .material = marble});
      add_node(scene, {.name = "beam", .translation = {x, 3.35, z}, .mesh = beam, .material = marble});
    }
  add_light(scene, directional_along({-0.6f, -0.7f, -0.35f}, {0.85f, 0.8f, 0.7f}));
  scene.camera = {.eye = {0.3, 1.7, 6.2}, .target = {0, 1.5, 0}, .fov_y = degrees(52), .near = 0.3f, .far = 80};
  return scene;
}

/// Extreme inputs: a spot straight above its target, floor outside the map, a light inside a shade that is a caster, a
/// light without casters in its reach, and a box that receives no shadow.
Scene edges() {
  Scene scene{.name = "edges"};
  scene.ambient = glm::vec3(0.06f);
  add_floor(scene, 14, glm::vec3(0.6f));
  const int clay = add_material(scene, {.name = "clay", .diffuse = {0.6f, 0.35f, 0.25f}}),
            tin = add_material(scene, {.name = "tin", .diffuse = glm::vec3(0.5f), .two_sided = true});
  add_object(scene, make_sphere({.radius = 0.4f}), clay, {.name = "ball", .translation = {0, 0.4, 0}});
  add_object(scene, make_cylinder_wall({.radius = 0.35f, .height = 0.5f}), tin,
             {.name = "shade", .translation = {-2.4, 1.4, 0}});
  add_object(scene, make_box({.size = glm::vec3(0.7f)}), clay,
             {.name = "unshaded", .translation = {2.2, 0.35, 0.4}, .receives_shadow = false});
  add_object(scene, make_box({.size = {0.2f, 1.6f, 0.2f}}), clay, {.name = "post", .translation = {1.5, 0.8, 0.9}});
  add_light(scene, {.type = LightType::spot,
                    .name = "above",
                    .position = {0, 3, 0},
                    .direction = {0, -1, 0},
                    .colour = glm::vec3(5),
                    .inner_angle = degrees(60),
                    .outer_angle = degrees(75)});
  add_light(scene, {.type = LightType::spot,
                    .name = "in the shade",
                    .position = {-2.4, 1.65, 0},
                    .direction = {0, -1, 0},
                    .colour = {2.4f, 1.9f, 1.0f},
                    .inner_angle = degrees(70),
                    .outer_angle = degrees(85)});
  add_light(scene, {.type = LightType::spot,
                    .name = "to the sky",
                    .position = {0, 5, -6},
                    .direction = {0, 1, 0},
                    .colour = glm::vec3(4),
                    .inner_angle = degrees(10),
                    .outer_angle = degrees(20)});
  scene.camera = {.eye = {0.4, 3.2, 6.4}, .target = {-0.2, 0.5, 0}, .fov_y = degrees(48), .near = 0.4f, .far = 30};
  return scene;
}

/// Rotates all lights about the vertical axis through the world's origin.
void turn_lights(Scene& scene, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turned = [&](const glm::dvec3& v) { return glm::dvec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x); };
  for (Light& light : scene.lights) {
    light.position = turned(light.position);
    light.direction = glm::vec3(turned(light.direction));
  }
}

void adjust(Scene& scene, const Settings& settings) {
  choose_casters(scene, settings);
  if (const double turn = settings.real("light.turn"); turn != 0) turn_lights(scene, double(degrees(turn)));
  if (const double scale = settings.real("scene.scale"); scale != 1) enlarge(scene, scale);
}

}  // namespace

void enlarge(Scene& scene, double factor) {
  for (Mesh& mesh : scene.meshes)
    for (Vertex& vertex : mesh.vertices) vertex.position *= float(factor);
  for (Node& node : scene.nodes) node.translation *= factor;
  for (Light& light : scene.lights) {
    light.position *= factor;
    light.attenuation.y /= float(factor);
    light.attenuation.z /= float(factor * factor);
  }
  Camera& camera = scene.camera;
  camera.eye *= factor, camera.target *= factor;
  camera.near *= float(factor), camera.far *= float(factor), camera.height *= float(factor);
}

SettingSpec scale_setting() {
  return {.name = "scene.scale",
          .fallback = 1.0,
          .low = 1e-3,
          .high = 1e5,
          .help = "factor by which the whole scene is enlarged; the picture should not change"};
}

SettingSpec casters_setting() {
  return {.name = "scene.casters",
          .fallback = std::string("flagged"),
          .choices = {"flagged", "all"},
          .help = "what casts shadows: the nodes that the scene marks as casters, or every node"};
}

void choose_casters(Scene& scene, const Settings& settings) {
  if (settings.choice("scene.casters") == "all")
    for (Node& node : scene.nodes) node.casts_shadow = true;
}

const SceneTable& shadow_scenes() {
  static const SceneTable scenes = adjusted(
      {
          {"teapot", [](const Settings&) { return make_teapot_scene(); }},
          {"grazing", grazing},
          {"table", [](const Settings&) { return table(); }},
          {"three-spots", [](const Settings&) { return three_spots(); }},
          {"penumbra", penumbra},
          {"colonnade", [](const Settings&) { return colonnade(); }},
          {"edges", [](const Settings&) { return edges(); }},
          {"cubes", [](const Settings&) { return make_cubes_scene(); }},
      },
      adjust);
  return scenes;
}

std::vector<SettingSpec> shadow_scene_settings() {
  return {
      {.name = "light.turn",
       .fallback = 0.0,
       .low = -360,
       .high = 360,
       .help = "degrees by which all lights are rotated about the vertical axis"},
      scale_setting(),
      casters_setting(),
      {.name = "grazing.angle",
       .fallback = 75.0,
       .low = 0,
       .high = 89.9,
       .help = "of the scene 'grazing': degrees between the floor's normal and the directional light, seen from the "
               "side; the true angle is up to 1.3 degrees larger"},
      {.name = "grazing.roll",
       .fallback = 0.0,
       .low = -180,
       .high = 180,
       .help = "of 'grazing': degrees by which floor, post and camera are rotated about the direction of the light, "
               "and so rotated in its map"},
      {.name = "penumbra.light",
       .fallback = 3.0,
       .low = 1,
       .high = 10,
       .help = "of 'penumbra': height of the light, m"},
      {.name = "penumbra.board",
       .fallback = 0.6,
       .low = 0.01,
       .high = 0.9,
       .help = "of 'penumbra': height of the board, m"},
      {.name = "penumbra.second",
       .fallback = 0.0,
       .low = 0,
       .high = 0.9,
       .help = "of 'penumbra': height of a second board above the same edge, m; 0: none"},
      {.name = "penumbra.turn",
       .fallback = 0.0,
       .low = -180,
       .high = 180,
       .help = "of 'penumbra': degrees by which the boards are rotated about the vertical axis, and so in the map"},
  };
}

}  // namespace atelier
