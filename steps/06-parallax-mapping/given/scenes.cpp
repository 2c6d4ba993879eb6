#include "06-parallax-mapping/given/scenes.hpp"

#include "scene/builder.hpp"
#include "scene/relief.hpp"
#include "scene/shapes.hpp"

namespace atelier {

namespace {

float depth_of(const Settings& settings) {
  return float(settings.real("parallax.depth"));
}

/// A plate of 2 x 2 m in the plane y = 0, seen at an angle of 35 degrees above it.
Scene plate(const char* name, int (*material)(Scene&, float depth), const Settings& settings) {
  Scene scene{.name = name};
  scene.ambient = glm::vec3(0.06f);
  const int relief = material(scene, depth_of(settings));
  add_object(scene, make_plane({.width = 2, .depth = 2}), relief, {.name = relief_node});
  add_light(scene, {.type = LightType::point, .position = {-1.1, 0.9, -0.6}, .colour = glm::vec3(1.9f)});
  scene.camera = {.eye = {0.4, 1.5, 2.1}, .target = {0, -0.05, 0}, .fov_y = degrees(46), .near = 0.1f, .far = 10};
  return scene;
}

int bricks(Scene& scene, float depth) {
  const Material rough{.name = "bricks", .diffuse = glm::vec3(0.95f), .specular = glm::vec3(0.05f), .exponent = 20};
  return add_relief(scene, rough, make_bricks({.size = 256, .columns = 3, .rows = 6, .depth = depth}), true);
}

const Material clay{.name = "clay", .diffuse = {0.6f, 0.42f, 0.3f}, .specular = glm::vec3(0.15f), .exponent = 30};

int dimples(Scene& scene, float depth) {
  return add_relief(scene, clay, make_dimples({.size = 256, .dimples = 4, .depth = depth}), false);
}

/// Narrow pillars on a deep ground: what every method misses first.
int pillars(Scene& scene, float depth) {
  constexpr int cells = 12;
  return add_relief(scene, clay,
                    make_relief(256, depth,
                                [](double u, double v) -> ReliefPoint {
                                  const glm::dvec2 p = glm::fract(glm::dvec2(u, v) * double(cells)) - 0.5;
                                  const double off = std::max(std::abs(p.x), std::abs(p.y));
                                  return {glm::dvec3(0.5), std::clamp((0.2 - off) / 0.06, 0.0, 1.0) * 0.95 + 0.05};
                                }),
                    false);
}

/// A plate that shows the texture two times and a half in one direction: its rim is not the texture's.
Scene rows(const Settings& settings) {
  Scene scene = plate("rows", bricks, settings);
  scene.meshes[0] = make_plane({.width = 2, .depth = 0.8f, .repeat = {2.5f, 1}});
  return scene;
}

/// A brick floor with a ball that is half below its surface and a box that stands in it.
Scene crossing(const Settings& settings) {
  Scene scene = plate("crossing", bricks, settings);
  const int white = add_material(scene, plastic("white", glm::vec3(0.75f), 60));
  add_object(scene, make_sphere({.radius = 0.3f}), white, {.name = "ball", .translation = {0.35, 0.02, 0.3}});
  add_object(scene, make_box({.size = {0.3f, 0.4f, 0.3f}}), white,
             {.name = "box", .translation = {-0.4, 0.02, 0.25}, .rotation_angle = degrees(25)});
  return scene;
}

/// A part of a round brick column before a wall, in a tilted view. Its texture is shown four times around, and as long
/// up as around. The seam is behind it.
Scene column(const Settings& settings) {
  constexpr float radius = 0.5f, around = 4, up = 3;
  constexpr float side = degrees(360) * radius / around;
  Scene scene{.name = "column"};
  scene.ambient = glm::vec3(0.08f);
  const int relief = bricks(scene, depth_of(settings));
  add_object(
      scene, make_cylinder_wall({.radius = radius, .height = up * side, .segments = 128, .repeat = {around, up}}),
      relief, {.name = round_relief_node, .translation = {0, -0.5f * up * side, 0}, .rotation_angle = degrees(90)});
  const int white = add_material(scene, plastic("white", glm::vec3(0.75f), 60));
  add_object(scene, make_plane({.width = 6, .depth = 6}), white,
             upright({.name = "wall", .translation = {0, 0, -1.5f}}, 0));
  add_light(scene, {.type = LightType::directional, .direction = {0.55f, -0.4f, -0.7f}, .colour = glm::vec3(0.9f)});
  scene.camera = {
      .eye = {0, 0.2f, 2.4f}, .target = {0, 0, 0}, .up = {0.3f, 1, 0}, .fov_y = degrees(26), .near = 0.1f, .far = 10};
  return scene;
}

/// Balls and a box before a wall: something to record.
Scene still_life(const Settings&) {
  Scene scene{.name = "still life"};
  scene.ambient = glm::vec3(0.1f);
  const int white = add_material(scene, plastic("white", glm::vec3(0.7f), 60));
  add_object(scene, make_plane({.width = 8, .depth = 8}), white, {.name = "floor"});
  add_object(scene, make_plane({.width = 8, .depth = 4}), white,
             upright({.name = "wall", .translation = {0, 2, -3}}, 0));
  add_object(scene, make_sphere({.radius = 0.7f}), white, {.name = "ball", .translation = {-0.8, 0.7, 0}});
  add_object(scene, make_box({.size = glm::vec3(1)}), white,
             {.name = "box", .translation = {0.8, 0.5, -1}, .rotation_angle = degrees(30)});
  add_light(scene, {.type = LightType::directional, .direction = {0.4f, -0.8f, -0.5f}, .colour = glm::vec3(0.8f)});
  scene.camera = {.eye = {0, 1.4, 4}, .target = {0, 0.8, 0}, .fov_y = degrees(45), .near = 0.2f, .far = 20};
  return scene;
}

}  // namespace

const SceneTable& parallax_scenes() {
  static const SceneTable scenes = {
      {"bricks", [](const Settings& settings) { return plate("bricks", bricks, settings); }},
      {"dimples", [](const Settings& settings) { return plate("dimples", dimples, settings); }},
      {"pillars", [](const Settings& settings) { return plate("pillars", pillars, settings); }},
      {"rows", rows},
      {"crossing", crossing},
      {"column", column},
      {"still-life", still_life},
      builtin_scene("room"),
  };
  return scenes;
}

}  // namespace atelier
