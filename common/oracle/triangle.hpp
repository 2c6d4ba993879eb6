// Watertight ray-triangle intersection: a ray through a shared edge or corner hits at least one of the triangles.
//
// After Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2 (2013): the corners are translated and
// sheared so that the ray becomes the z axis; the ray hits the triangle if the origin is inside its projection, which
// three signed areas decide. A corner is transformed identically for every triangle, and both neighbours compute the
// area over a shared edge from the same two products with opposite signs: if it is outside for one, it is inside for
// the other, and zero counts as inside for both.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "oracle/ray.hpp"

namespace atelier::oracle {

/// A ray with its shear to the z axis, computed once for all triangles.
class ShearedRay {
 public:
  explicit ShearedRay(const Ray& ray);

  const Ray& ray() const { return ray_; }
  /// A point in the ray's coordinates: x and y perpendicular to it, z in units of t.
  glm::dvec3 sheared(const glm::dvec3& point) const {
    const glm::dvec3 p = point - ray_.origin;
    return {p[x_] - shear_.x * p[z_], p[y_] - shear_.y * p[z_], shear_.z * p[z_]};
  }

 private:
  Ray ray_;
  int x_, y_, z_;     ///< the world axes used as x, y and z; z is the one with the largest direction component
  glm::dvec3 shear_;  ///< shear of x and y per unit of z, and t per unit of z
};

struct TriangleHit {
  double t = 0;
  double b = 0, c = 0;  ///< barycentric weights of the second and third corner; the first has 1 - b - c
  bool front = true;    ///< the corners run counter-clockwise, seen from the ray's origin
};

/// The intersection with a triangle within the ray's interval. Triangles without area and those seen exactly edge-on
/// are never hit.
std::optional<TriangleHit> intersect(const ShearedRay& ray, const glm::dvec3& first, const glm::dvec3& second,
                                     const glm::dvec3& third);

}  // namespace atelier::oracle
