#include "oracle/shape.hpp"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "oracle/height_field.hpp"

namespace atelier::oracle {

namespace {

constexpr double tau = 2 * glm::pi<double>();

/// Where o + t d is `radius` from the origin, in the plane (a cylinder) or in space (a sphere), the smaller t first.
/// Accurate for origins far away and near the surface: the discriminant comes from the ray's closest approach (Haines
/// et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019), and the root with
/// cancellation is computed from the product of both.
template <class Vector>
std::optional<std::array<double, 2>> at_radius(const Vector& o, const Vector& d, double radius) {
  const double a = glm::dot(d, d);
  if (a == 0) return std::nullopt;
  const double closest_t = -glm::dot(o, d) / a;
  const Vector closest = o + closest_t * d;
  const double half_chord_squared = radius * radius - glm::dot(closest, closest);
  if (!(half_chord_squared >= 0)) return std::nullopt;
  const double product = (glm::length(o) - radius) * (glm::length(o) + radius) / a;
  const double larger = closest_t + std::copysign(std::sqrt(half_chord_squared / a), closest_t);
  const double smaller = larger != 0 ? product / larger : 0;
  return larger < smaller ? std::array{larger, smaller} : std::array{smaller, larger};
}

bool counts(const Ray& ray, double t) {
  return t >= ray.least && t <= ray.most;
}

bool faces(const Ray& ray, const glm::dvec3& normal) {
  return glm::dot(ray.direction, normal) < 0;
}

/// The angle from +x to (x, y) as a fraction of a full turn, 0 <= fraction < 1.
double turn_share(double x, double y) {
  const double share = std::atan2(y, x) / tau;
  return share < 0 ? share + 1 : share;
}

std::optional<ShapeHit> meet(const Sphere& sphere, const Ray& ray, bool front_only) {
  const auto roots = at_radius(ray.origin, ray.direction, sphere.radius);
  if (!roots) return std::nullopt;
  for (const double t : *roots) {
    if (!counts(ray, t)) continue;
    const glm::dvec3 normal = glm::normalize(ray.at(t));
    if (front_only && !faces(ray, normal)) continue;
    const double v = std::asin(glm::clamp(normal.y, -1.0, 1.0)) / glm::pi<double>() + 0.5;
    return ShapeHit{t, normal, {turn_share(normal.x, -normal.z), v}};
  }
  return std::nullopt;
}

std::optional<ShapeHit> meet(const CylinderWall& wall, const Ray& ray, bool front_only) {
  const auto roots =
      at_radius(glm::dvec2(ray.origin.x, ray.origin.z), glm::dvec2(ray.direction.x, ray.direction.z), wall.radius);
  if (!roots) return std::nullopt;
  for (const double t : *roots) {
    const glm::dvec3 point = ray.at(t);
    if (!counts(ray, t) || point.y < 0 || point.y > wall.height) continue;
    const glm::dvec3 outwards = glm::normalize(glm::dvec3(point.x, 0, point.z));
    const glm::dvec3 normal = wall.inside ? -outwards : outwards;
    if (front_only && !faces(ray, normal)) continue;
    const double u = wall.repeat * turn_share(point.x, wall.inside ? point.z : -point.z);
    return ShapeHit{t, normal, {u, point.y / wall.height}};
  }
  return std::nullopt;
}

std::optional<ShapeHit> meet(const Rectangle& flat, const Ray& ray, bool front_only) {
  const glm::dvec3 normal = glm::normalize(glm::cross(flat.half_u, flat.half_v));
  const double slope = glm::dot(ray.direction, normal);
  if (slope == 0 || (front_only && slope > 0)) return std::nullopt;
  const double t = glm::dot(flat.centre - ray.origin, normal) / slope;
  if (!counts(ray, t)) return std::nullopt;
  const glm::dvec3 from_centre = ray.at(t) - flat.centre;
  const double a = glm::dot(from_centre, flat.half_u) / glm::dot(flat.half_u, flat.half_u),
               b = glm::dot(from_centre, flat.half_v) / glm::dot(flat.half_v, flat.half_v);
  if (!(std::abs(a) <= 1 && std::abs(b) <= 1)) return std::nullopt;
  return ShapeHit{t, normal, {(a + 1) / 2, (b + 1) / 2}};
}

std::optional<ShapeHit> meet(const HeightField& field, const Ray& ray, bool front_only) {
  return intersect(field, ray, front_only);
}

/// The bounding box of the surface in its own space.
Box3 own_bounds(const Surface& surface) {
  Box3 box;
  if (const auto* sphere = std::get_if<Sphere>(&surface)) {
    box.add(glm::dvec3(-sphere->radius));
    box.add(glm::dvec3(sphere->radius));
  } else if (const auto* wall = std::get_if<CylinderWall>(&surface)) {
    box.add({-wall->radius, 0, -wall->radius});
    box.add({wall->radius, wall->height, wall->radius});
  } else if (const auto* field = std::get_if<HeightField>(&surface)) {
    box = own_bounds(field->flat);
    const glm::dvec3 down = -field->depth * glm::normalize(glm::cross(field->flat.half_u, field->flat.half_v));
    box.add(Box3{box.low + down, box.high + down});
  } else {
    const auto& flat = std::get<Rectangle>(surface);
    for (const double a : {-1.0, 1.0})
      for (const double b : {-1.0, 1.0}) box.add(flat.centre + a * flat.half_u + b * flat.half_v);
  }
  return box;
}

}  // namespace

std::optional<ShapeHit> intersect(const Surface& surface, const Ray& ray, bool front_only) {
  return std::visit([&](const auto& s) { return meet(s, ray, front_only); }, surface);
}

Box3 bounds(const Shape& shape) {
  Box3 box = box_around(corners_of(own_bounds(shape.surface), shape.object_to_world));
  const glm::dvec3 margin = 1e-12 * (glm::abs(box.low) + glm::abs(box.high) + (box.high - box.low));
  box.low -= margin;
  box.high += margin;
  return box;
}

}  // namespace atelier::oracle
