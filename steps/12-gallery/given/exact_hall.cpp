#include "12-gallery/given/exact_hall.hpp"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/shapes.hpp"

namespace atelier {

HallParts exact_hall(int segments) {
  HallParts parts{.wall = make_cylinder_wall({.radius = float(hall_radius),
                                              .height = float(hall_height),
                                              .segments = segments,
                                              .side = Side::inside,
                                              .repeat = {wall_repeat, 1}})};
  // The library's wall begins at +x; a quarter turn, clockwise from above, brings that corner to +z.
  for (Vertex& vertex : parts.wall.vertices)
    for (glm::vec3* v : {&vertex.position, &vertex.normal}) *v = {-v->z, v->y, v->x};
  for (int i = 0; i < paintings_in_hall; ++i) {
    const double turn = glm::two_pi<double>() * i / paintings_in_hall;
    const glm::dvec3 ahead(std::sin(turn), 0, std::cos(turn));
    parts.paintings[std::size_t(i)] =
        upright_frame(glm::dvec3(0, painting_height, 0) - painting_distance(segments) * ahead, ahead);
  }
  return parts;
}

}  // namespace atelier
