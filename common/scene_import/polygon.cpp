#include "scene_import/polygon.hpp"

#include <cmath>
#include <numeric>

namespace atelier::scene_import {
namespace {

/// Twice the signed area of a triangle in the plane, positive counter-clockwise.
double area2(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

/// The corners projected along the mean normal, counter-clockwise.
std::vector<glm::dvec2> flatten(std::span<const glm::vec3> corners) {
  const glm::dvec3 n = newell_normal(corners);
  // Drop the axis closest to the normal; order the other two so that the winding is kept.
  const glm::dvec3 size = glm::abs(n);
  const int dropped = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  const int right = (dropped + 1) % 3, up = (dropped + 2) % 3;
  const double sign = n[dropped] < 0 ? -1 : 1;
  std::vector<glm::dvec2> flat;
  for (const glm::vec3& p : corners) flat.emplace_back(p[right], sign * p[up]);
  return flat;
}

bool is_convex(const std::vector<glm::dvec2>& p) {
  const std::size_t n = p.size();
  double turns = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 &a = p[i], &b = p[(i + 1) % n], &c = p[(i + 2) % n];
    if (area2(a, b, c) < 0) return false;
    const glm::dvec2 e = b - a, f = c - b;
    turns += std::atan2(e.x * f.y - e.y * f.x, glm::dot(e, f));
  }
  return turns < 7;  // one turn is 2 pi; a star with two turns also turns left everywhere
}

bool is_inside(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return area2(a, b, p) >= 0 && area2(b, c, p) >= 0 && area2(c, a, p) >= 0;
}

/// Whether the triangle at index i of the outline lies inside the polygon and contains no other corner.
bool is_ear(const std::vector<glm::dvec2>& p, const std::vector<int>& outline, std::size_t i) {
  const std::size_t n = outline.size();
  const glm::dvec2 &a = p[outline[(i + n - 1) % n]], &b = p[outline[i]], &c = p[outline[(i + 1) % n]];
  if (area2(a, b, c) <= 0) return false;
  for (const int other : outline) {
    const glm::dvec2& q = p[other];
    if (q != a && q != b && q != c && is_inside(q, a, b, c)) return false;
  }
  return true;
}

std::vector<std::array<int, 3>> cut_ears(const std::vector<glm::dvec2>& p) {
  std::vector<int> outline(p.size());
  std::iota(outline.begin(), outline.end(), 0);
  std::vector<std::array<int, 3>> triangles;
  std::size_t i = 0, refused = 0;
  while (outline.size() > 3) {
    const std::size_t n = outline.size();
    i %= n;
    // A self-intersecting outline may have no ear: cut anyway, so that the loop ends.
    if (!is_ear(p, outline, i) && refused < n) {
      ++i, ++refused;
      continue;
    }
    triangles.push_back({outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]});
    outline.erase(outline.begin() + std::ptrdiff_t(i));
    refused = 0;
  }
  triangles.push_back({outline[0], outline[1], outline[2]});
  return triangles;
}

}  // namespace

glm::dvec3 newell_normal(std::span<const glm::vec3> corners) {
  // Relative to the first corner, so that a polygon far from the origin keeps its precision.
  glm::dvec3 sum(0);
  const glm::dvec3 origin(corners[0]);
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[(i + 1) % corners.size()]) - origin);
  return sum;
}

std::vector<std::array<int, 3>> triangulate(std::span<const glm::vec3> corners) {
  const int n = int(corners.size());
  if (n < 3) return {};
  if (n == 3) return {{0, 1, 2}};
  const std::vector<glm::dvec2> flat = flatten(corners);
  if (!is_convex(flat)) return cut_ears(flat);
  std::vector<std::array<int, 3>> fan;
  for (int i = 1; i + 1 < n; ++i) fan.push_back({0, i, i + 1});
  return fan;
}

}  // namespace atelier::scene_import
