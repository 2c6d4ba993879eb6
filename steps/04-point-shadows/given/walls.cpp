#include "04-point-shadows/given/walls.hpp"

#include "scene/builder.hpp"
#include "scene/shapes.hpp"

namespace atelier {

void add_walls(Scene& scene, const Walls& walls) {
  const int wall = add_mesh(scene, make_plane({.width = float(walls.side), .depth = float(walls.side)}));
  const auto add = [&](const char* name, const glm::dvec3& at, const glm::vec3& axis, double angle) {
    add_node(scene, {.name = name,
                     .parent = walls.parent,
                     .translation = walls.middle + walls.distance * at,
                     .rotation_axis = axis,
                     .rotation_angle = degrees(angle),
                     .mesh = wall,
                     .material = walls.material,
                     .casts_shadow = walls.cast});
  };
  add("floor", {0, -1, 0}, {1, 0, 0}, 0);
  add("ceiling", {0, 1, 0}, {1, 0, 0}, 180);
  add("back", {0, 0, -1}, {1, 0, 0}, 90);
  add("front", {0, 0, 1}, {1, 0, 0}, -90);
  add("left", {-1, 0, 0}, {0, 0, 1}, -90);
  add("right", {1, 0, 0}, {0, 0, 1}, 90);
}

}  // namespace atelier
