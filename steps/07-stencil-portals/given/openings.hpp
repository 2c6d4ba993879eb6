// Portals and mirrors as they stand in the world, with the student's functions. Given.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "render/view.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// A portal or a mirror.
struct Opening {
  int node = 0, exit_node = 0;   ///< a mirror is its own exit
  glm::dmat4 frame{1}, exit{1};  ///< their nodes, to world
  glm::dmat4 passage{1};         ///< from the world to the world
  glm::dvec2 half_size{0};       ///< of the rectangle around it, metres
  bool mirror = false, two_sided = false;
  glm::vec3 colour{0};

  /// Of its rectangle, counter-clockwise, in the world.
  std::array<glm::dvec4, 4> corners() const;
};

/// Those of a valid scene, in its order.
std::vector<Opening> openings_of(const Scene& scene);

/// The same frame, seen from behind: turned by half a turn about its y axis.
glm::dmat4 from_behind(const glm::dmat4& frame);

/// Whether a point of the world is on the side that a frame's +z faces, or on its plane.
bool before(const glm::dmat4& frame, const glm::dvec3& point);

/// Whether all of these points of the world are beyond the far plane of a view.
bool beyond_far_plane(std::span<const glm::dvec4> points, const Viewpoint& viewpoint);

}  // namespace atelier
