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

/// The part of a window from `low` to `high`, metres along right and up from its middle.
class Beam {
 public:
  /// `gap`: rays may run so many metres beside where the window says, and start at least so far off surfaces.
  Beam(const glm::dvec3& apex, const Window& window, const glm::dvec2& low, const glm::dvec2& high, double gap);

  /// Whether no ray of the beam meets the box. May say false where none does, never true where one does.
  bool misses(const Box3& box) const;
  /// The same for anything within the convex hull of these points,
  bool misses(std::span<const glm::dvec3> points) const;
  /// and for anything in the plane through `point` along both sides: the beam stays in front of it, or behind.
  bool misses_plane(const glm::dvec3& point, const glm::dvec3& side, const glm::dvec3& other_side) const;

 private:
  /// What lies in the beam has dot(normal, position - apex) <= most.
  struct HalfSpace {
    glm::dvec3 normal{0};  ///< of unit length, or zero: everything lies in it
    double most = 0;
  };

  glm::dvec3 apex_;
  std::array<glm::dvec3, 4> ends_;  ///< from the apex
  bool endless_;
  double gap_, reach_;
  std::array<HalfSpace, 6> half_spaces_;  ///< left, right, below, above, behind the apex, beyond the end
};

}  // namespace atelier::oracle
