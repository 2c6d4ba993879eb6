#include "04-point-shadows/given/cube_room.hpp"

#include "scene/builder.hpp"
#include "scene/shapes.hpp"
#include "scene/textures.hpp"

namespace atelier {

Scene make_cube_room_scene() {
  Scene scene{.name = "cube-room"};
  scene.ambient = glm::vec3(0.09f);
  scene.background = glm::vec3(0.1f);
  const int texture = add_texture(scene, "wood", make_wood());
  const int wood = add_material(scene, {.name = "wood",
                                        .diffuse = glm::vec3(1),
                                        .specular = glm::vec3(0.5f),
                                        .exponent = 64,
                                        .diffuse_texture = texture});
  add_object(scene, make_box({.size = glm::vec3(10), .side = Side::inside}), wood,
             {.name = "room", .casts_shadow = false});
  const int box = add_mesh(scene, make_box({.size = glm::vec3(1)}));
  const auto put = [&](const glm::dvec3& at, float side, double angle) {
    add_node(scene, {.name = "box",
                     .translation = at,
                     .rotation_axis = {1, 0, 1},
                     .rotation_angle = degrees(angle),
                     .scale = glm::vec3(side),
                     .mesh = box,
                     .material = wood});
  };
  put({4, -3.5, 0}, 1, 0);
  put({2, 3, 1}, 1.5f, 0);
  put({-3, -1, 0}, 1, 0);
  put({-1.5, 1, 1.5}, 1, 0);
  put({-1.5, 2, -3}, 1.5f, 60);
  add_light(scene, {.type = LightType::point,
                    .name = "lamp",
                    .position = glm::dvec3(0),
                    .colour = glm::vec3(0.3f),
                    .attenuation = {1, 0, 0}});
  scene.camera = {.eye = {0, 0, 3}, .target = {0, 0, 2}, .fov_y = degrees(45), .near = 0.1f, .far = 100};
  return scene;
}

}  // namespace atelier
