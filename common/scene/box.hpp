// Boxes along the axes, around points: what is drawn lies inside.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

namespace atelier {

struct Mesh;

/// The smallest axis-aligned box around points, empty when made.
struct Box3 {
  glm::dvec3 low{1e300}, high{-1e300};
  bool empty() const { return low.x > high.x; }
  void add(const glm::dvec3& point) { low = glm::min(low, point), high = glm::max(high, point); }
  void add(const Box3& other) { low = glm::min(low, other.low), high = glm::max(high, other.high); }
};

/// Around points; empty around none.
Box3 box_around(std::span<const glm::dvec3> points);

/// Around all vertices of a mesh, whether a triangle uses them or not: in object space, or where an affine matrix takes
/// them.
Box3 box_around(const Mesh& mesh);
Box3 box_around(const Mesh& mesh, const glm::dmat4& matrix);

/// Its eight corners: bit 0 of the index tells high from low in x, bit 1 in y, bit 2 in z.
std::array<glm::dvec3, 8> corners_of(const Box3& box);

/// The same where an affine matrix takes them: object space to world space, say.
std::array<glm::dvec3, 8> corners_of(const Box3& box, const glm::dmat4& matrix);

/// A sphere around points: centre and radius, in the points' unit.
struct Ball {
  glm::dvec3 centre{0};
  double radius = 0;
};

/// Around the middle of the points' box, as small as holds them all: up to sqrt(3) times the smallest radius there is.
/// Around none: at the origin, of radius 0.
Ball ball_around(std::span<const glm::dvec3> points);

}  // namespace atelier
