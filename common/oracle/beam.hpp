// A pyramid of rays from one point, for conservative culling: soft shadows skip objects that no ray of the beam can
// intersect. Single rays are always tested exactly.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "oracle/frame.hpp"
#include "scene/scene.hpp"

namespace atelier::oracle {

/// A rectangle as seen from a point: of points, with its centre at `middle` metres from the apex, or of directions. Its
/// sides run along right and up of the frame.
struct Window {
  ViewFrame frame;
  glm::dvec3 middle{0, 0, -1};  ///< from the point to the rectangle's centre
  bool endless = false;         ///< directions: rays are infinite; otherwise they end on the rectangle
};

/// The part of a window from `low` to `high`, along right and up from its centre, in metres, or for directions without
/// unit.
class Beam {
 public:
  /// Rays may deviate from the window by up to 2 `bend`, in its unit.
  Beam(const glm::dvec3& apex, const Window& window, const glm::dvec2& low, const glm::dvec2& high, double bend);

  /// Whether no ray of the beam intersects the box. Conservative: true only if none does.
  bool misses(const Box3& box) const;
  /// The same for a planar convex face with these corners, 3 or more in order around it.
  bool misses(std::span<const glm::dvec3> corners) const;

 private:
  bool all_outside_one_half_space(std::span<const glm::dvec3> corners) const;
  bool stays_on_one_side(std::span<const glm::dvec3> corners) const;
  bool passes_an_edge(std::span<const glm::dvec3> corners) const;

  /// Points of the beam have dot(normal, position - apex) <= most.
  struct HalfSpace {
    glm::dvec3 normal{0};  ///< of unit length, or zero: contains everything
    double most = 0;
  };

  glm::dvec3 apex_;
  std::array<glm::dvec3, 4> ends_;  ///< from the apex
  bool endless_;
  double bend_, reach_ = 0;               ///< reach: distance of the farthest end
  std::array<HalfSpace, 6> half_spaces_;  ///< left, right, below, above, behind the apex, beyond the end
};

}  // namespace atelier::oracle
