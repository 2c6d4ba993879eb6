#include "oracle/triangle.hpp"

#include <cmath>
#include <utility>

namespace atelier::oracle {

ShearedRay::ShearedRay(const Ray& ray) : ray_(ray) {
  const glm::dvec3 size = glm::abs(ray.direction);
  z_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  x_ = (z_ + 1) % 3;
  y_ = (z_ + 2) % 3;
  if (ray.direction[z_] < 0) std::swap(x_, y_);  // keeps the orientation
  shear_ = {ray.direction[x_] / ray.direction[z_], ray.direction[y_] / ray.direction[z_], 1 / ray.direction[z_]};
}

std::optional<TriangleHit> intersect(const ShearedRay& ray, const glm::dvec3& first, const glm::dvec3& second,
                                     const glm::dvec3& third) {
  const glm::dvec3 a = ray.sheared(first), b = ray.sheared(second), c = ray.sheared(third);
  const double over_a = c.x * b.y - c.y * b.x, over_b = a.x * c.y - a.y * c.x, over_c = b.x * a.y - b.y * a.x;
  const bool negative = over_a < 0 || over_b < 0 || over_c < 0;
  const bool positive = over_a > 0 || over_b > 0 || over_c > 0;
  if (negative == positive) return std::nullopt;  // outside, or a triangle without area
  const double sum = over_a + over_b + over_c;
  const double t = (over_a * a.z + over_b * b.z + over_c * c.z) / sum;
  if (!(t >= ray.ray().least && t <= ray.ray().most)) return std::nullopt;  // NaN too
  return TriangleHit{t, over_b / sum, over_c / sum, sum > 0};
}

}  // namespace atelier::oracle
