// A pyramid of rays from one point, and what certainly lies outside it. It lets shadows of lights with an extent leave
// out, for many rays at once, what none of them can meet; it never decides about a single ray.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "oracle/frame.hpp"
#include "scene/scene.hpp"

namespace atelier::oracle {

/// A rectangle as seen from a point: of points, `middle` metres from it, or of directions. Its sides run along right
/// and up of the frame.
struct Window {
  ViewFrame frame;
  glm::dvec3 middle{0, 0, -1};  ///< from the point to the rectangle's middle
  bool endless = false;         ///< directions: rays go on for ever; otherwise they end on the rectangle
};

/// The part of a window from `low` to `high`, along right and up from its middle, in its unit: metres, or of
/// directions 1.
class Beam {
 public:
  /// The ends of rays may lie up to 2 `bend` beside where the window says, in its unit.
  Beam(const glm::dvec3& apex, const Window& window, const glm::dvec2& low, const glm::dvec2& high, double bend);

  /// Whether no ray of the beam meets the box. May say false where none does, never true where one does.
  bool misses(const Box3& box) const;
  /// The same of a flat convex face with these corners, 3 or more in their order around it.
  bool misses(std::span<const glm::dvec3> corners) const;

 private:
  bool all_outside_one_half_space(std::span<const glm::dvec3> corners) const;
  bool stays_on_one_side(std::span<const glm::dvec3> corners) const;
  bool passes_an_edge(std::span<const glm::dvec3> corners) const;

  /// What lies in the beam has dot(normal, position - apex) <= most.
  struct HalfSpace {
    glm::dvec3 normal{0};  ///< of unit length, or zero: everything lies in it
    double most = 0;
  };

  glm::dvec3 apex_;
  std::array<glm::dvec3, 4> ends_;  ///< from the apex
  bool endless_;
  double bend_, reach_ = 0;               ///< reach: of the farthest end
  std::array<HalfSpace, 6> half_spaces_;  ///< left, right, below, above, behind the apex, beyond the end
};

}  // namespace atelier::oracle
