#include "@STEP@/given/scenes.hpp"

#include "scene/builder.hpp"
#include "scene/shapes.hpp"

namespace atelier {

namespace {

/// Two rows of posts beside a road, from near to far, which show the effect of fog with distance.
Scene posts() {
  Scene scene{.name = "posts"};
  scene.ambient = glm::vec3(0.1f);
  const int ground = add_material(scene, {.name = "ground", .diffuse = {0.2f, 0.25f, 0.15f}});
  const int paint = add_material(scene, {.name = "paint", .diffuse = {0.8f, 0.15f, 0.1f}});
  add_object(scene, make_plane({.width = 40, .depth = 90}), ground, {.name = "ground", .translation = {0, 0, -40}});
  const int post = add_mesh(scene, make_box({.size = {0.4f, 2, 0.4f}}));
  for (int i = 0; i < 8; ++i)
    for (const double side : {-1.6, 1.6})
      add_node(scene, {.name = "post", .translation = {side, 1, -5.0 * i}, .mesh = post, .material = paint});
  add_light(scene, {.type = LightType::directional, .direction = {-0.4f, -1, -0.6f}, .colour = glm::vec3(0.9f)});
  scene.camera = {.eye = {0, 1.9, 5}, .target = {0, 1, -12}, .fov_y = degrees(45), .near = 0.5f, .far = 120};
  return scene;
}

}  // namespace

const SceneTable& @NAME@_scenes() {
  static const SceneTable scenes = {
      {"posts", [](const Settings&) { return posts(); }},
      builtin_scene("room"),
  };
  return scenes;
}

}  // namespace atelier
