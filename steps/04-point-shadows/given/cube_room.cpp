#include "04-point-shadows/given/cube_room.hpp"

#include "03-shadow-mapping/given/three_cubes.hpp"
#include "scene/builder.hpp"
#include "scene/shapes.hpp"

namespace atelier {

Scene make_cube_room_scene() {
  Scene scene = make_wooden_scene("cube-room");
  constexpr int wood = 0;
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
  return scene;
}

}  // namespace atelier
