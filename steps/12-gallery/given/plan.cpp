#include "12-gallery/given/plan.hpp"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "12-gallery/gallery.hpp"

namespace atelier {

namespace {

double apothem(int segments) {
  return hall_radius * std::cos(glm::pi<double>() / segments);
}

}  // namespace

glm::dmat4 upright_frame(const glm::dvec3& centre, const glm::dvec3& ahead) {
  const glm::dvec3 up(0, 1, 0);
  return {glm::dvec4(glm::cross(up, ahead), 0), glm::dvec4(up, 0), glm::dvec4(ahead, 0), glm::dvec4(centre, 1)};
}

double painting_distance(int segments) {
  const double half_width = painting_half_size.x + 0.2;  // with the frame
  return std::sqrt(apothem(segments) * apothem(segments) - half_width * half_width) - painting_gap;
}

glm::dmat4 door_frame() {
  return upright_frame(bedroom_centre + glm::dvec3(0, painting_height, bedroom_size.z / 2 - painting_gap), {0, 0, -1});
}

std::array<glm::dmat4, paintings_in_hall> students_paintings(int segments) {
  std::array<glm::dmat4, paintings_in_hall> frames;
  for (int i = 0; i < paintings_in_hall; ++i)
    frames[std::size_t(i)] =
        gallery::painting_frame(i, paintings_in_hall, painting_distance(segments), painting_height);
  return frames;
}

HallParts students_hall(int segments) {
  return {.wall = gallery::hall_wall(segments, float(hall_radius), float(hall_height), wall_repeat),
          .paintings = students_paintings(segments)};
}

std::vector<glm::dvec4> walls_of_hall(int segments) {
  std::vector<glm::dvec4> walls;
  for (int i = 0; i < segments; ++i) {
    const double turn = glm::two_pi<double>() * (i + 0.5) / segments;
    walls.emplace_back(std::sin(turn), 0, -std::cos(turn), apothem(segments));
  }
  return walls;
}

std::vector<glm::dvec4> walls_of_bedroom() {
  const glm::dvec3 half = bedroom_size / 2.0, centre = bedroom_centre;
  return {{1, 0, 0, half.x - centre.x},
          {-1, 0, 0, half.x + centre.x},
          {0, 0, 1, half.z - centre.z},
          {0, 0, -1, half.z + centre.z}};
}

}  // namespace atelier
