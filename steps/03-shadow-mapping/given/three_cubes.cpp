#include "03-shadow-mapping/given/three_cubes.hpp"

#include "scene/builder.hpp"
#include "scene/shapes.hpp"
#include "scene/textures.hpp"

namespace atelier {

Scene make_wooden_scene(const std::string& name) {
  Scene scene{.name = name};
  scene.ambient = glm::vec3(0.09f);
  scene.background = glm::vec3(0.1f);
  const int texture = add_texture(scene, "wood", make_wood());
  add_material(scene, {.name = "wood",
                       .diffuse = glm::vec3(1),
                       .specular = glm::vec3(0.5f),
                       .exponent = 64,
                       .diffuse_texture = texture});
  scene.camera = {.eye = {0, 0, 3}, .target = {0, 0, 2}, .fov_y = degrees(45), .near = 0.1f, .far = 100};
  return scene;
}

Scene make_cubes_scene() {
  Scene scene = make_wooden_scene("cubes");
  constexpr int wood = 0;
  add_object(scene, make_plane({.width = 50, .depth = 50, .repeat = {25, 25}}), wood,
             {.name = "floor", .translation = {0, -0.5, 0}, .casts_shadow = false});
  const int box = add_mesh(scene, make_box({.size = glm::vec3(1)}));
  add_node(scene, {.name = "high box", .translation = {0, 1.5, 0}, .mesh = box, .material = wood});
  add_node(scene, {.name = "box", .translation = {2, 0, 1}, .mesh = box, .material = wood});
  add_node(scene, {.name = "tilted box",
                   .translation = {-1, 0, 2},
                   .rotation_axis = {1, 0, 1},
                   .rotation_angle = degrees(60),
                   .scale = glm::vec3(0.5f),
                   .mesh = box,
                   .material = wood});
  add_light(scene, {.type = LightType::directional, .name = "sun", .direction = {2, -4, 1}, .colour = glm::vec3(0.3f)});
  return scene;
}

}  // namespace atelier
