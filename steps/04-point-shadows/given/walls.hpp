// Rooms for scenes with point lights. Given.
#pragma once

#include "scene/scene.hpp"

namespace atelier {

/// Six square walls that face inwards, floor and ceiling among them.
struct Walls {
  double distance = 3;  ///< metres from the middle to each
  double side = 6;      ///< of a wall; below twice the distance they do not touch
  int material = 0;
  bool cast = false;
  int parent = -1;       ///< the node in whose space they are
  glm::dvec3 middle{0};  ///< in that space
};
void add_walls(Scene& scene, const Walls& walls);

}  // namespace atelier
