// The plan of the gallery: where its hall, its paintings and its rooms are. Given.
//
// All six paintings lead to the same bedroom, far away from the hall: the six rooms differ in nothing but the style in
// which they are seen, and so share their geometry, their lamp and its shadows.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.hpp"

namespace atelier {

constexpr int paintings_in_hall = 6;
inline constexpr glm::dvec2 painting_half_size{1, 1};  // metres
constexpr double painting_height = 1.6;                // of the centre above the floor
constexpr double painting_gap = 0.15;                  // to the wall, for the relief
constexpr double hall_radius = 6, hall_height = 3.6;   // metres, to the corners of the wall
constexpr float wall_repeat = 10;                      // of its paper

inline constexpr glm::dvec3 bedroom_size{5, 3, 6};      // metres
inline constexpr glm::dvec3 bedroom_centre{0, 0, 512};  // on the floor; no light of the hall is seen there

/// The distance of the paintings from the axis: the wall behind them is painting_gap away, or more.
double painting_distance(int segments);

/// A frame with +y up.
glm::dmat4 upright_frame(const glm::dvec3& centre, const glm::dvec3& ahead);

/// The bedroom's door, as a frame: +z into the room.
glm::dmat4 door_frame();

/// What the student's functions make of the hall, or their exact counterparts (exact_hall.hpp).
struct HallParts {
  Mesh wall;
  std::array<glm::dmat4, paintings_in_hall> paintings;
};

std::array<glm::dmat4, paintings_in_hall> students_paintings(int segments);
HallParts students_hall(int segments);

/// The walls of the hall and of the bedroom, as planes (n, d): |n| = 1, positive inside.
std::vector<glm::dvec4> walls_of_hall(int segments);
std::vector<glm::dvec4> walls_of_bedroom();

}  // namespace atelier
