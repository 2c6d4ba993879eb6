// Ray and triangle, without gaps: a ray that meets the edge or the corner where triangles join meets at least one of
// them.
//
// After Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2 (2013): the corners are moved and
// sheared so that the ray becomes the axis z; the ray meets the triangle where the origin lies inside its projection,
// which three signed areas tell. A corner comes out the same for every triangle that it belongs to, and the area over a
// shared edge is computed from the same two products by both neighbours, with opposite signs: what one calls outside,
// the other calls inside, and zero counts as inside for both.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "oracle/ray.hpp"

namespace atelier::oracle {

/// A ray with the shear that makes it the axis z: worked out once, used for every triangle.
class ShearedRay {
 public:
  explicit ShearedRay(const Ray& ray);

  const Ray& ray() const { return ray_; }
  /// A point as seen along the ray: x and y across it, z in units of t.
  glm::dvec3 sheared(const glm::dvec3& point) const {
    const glm::dvec3 p = point - ray_.origin;
    return {p[x_] - shear_.x * p[z_], p[y_] - shear_.y * p[z_], shear_.z * p[z_]};
  }

 private:
  Ray ray_;
  int x_, y_, z_;     ///< which axes of the world play x, y and z; z is the one that the ray runs along most
  glm::dvec3 shear_;  ///< x and y lost for each unit of z, and t for each unit of z
};

struct TriangleHit {
  double t = 0;
  double b = 0, c = 0;  ///< barycentric weights of the second and third corner; the first has 1 - b - c
  bool front = true;    ///< the corners run counter-clockwise, seen from the ray's origin
};

/// Where the ray meets a triangle within its stretch. Triangles without area, and those that are seen exactly along
/// their plane, are never met.
std::optional<TriangleHit> intersect(const ShearedRay& ray, const glm::dvec3& first, const glm::dvec3& second,
                                     const glm::dvec3& third);

}  // namespace atelier::oracle
