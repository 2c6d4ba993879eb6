// The scenes of step 01; each shows the effect of one function. Given.
#pragma once

#include <array>

#include "app/scene_table.hpp"

namespace atelier {

const SceneTable& transform_scenes();
std::vector<SettingSpec> transform_scene_settings();

/// Size of the cylindrical hall, metres.
inline constexpr float hall_radius = 6, hall_height = 4;

/// The hall's camera and its materials (0 the wall's, 1 the floor's, 2 the ceiling's), without any geometry.
Scene empty_hall();

/// The scene "triangle": corners in clip space, linear colours.
inline constexpr std::array<glm::vec3, 3> triangle_corners = {glm::vec3(-0.8f, -0.6f, 0), glm::vec3(0.7f, -0.8f, 0),
                                                              glm::vec3(0.1f, 0.8f, 0)};
inline constexpr glm::vec3 triangle_colour{0.9f, 0.5f, 0.1f}, triangle_background{0.05f, 0.06f, 0.08f};

}  // namespace atelier
