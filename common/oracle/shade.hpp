// The colour of a point of a surface: every light of the scene, and what the surface makes of it.
#pragma once

#include "oracle/shading.hpp"

namespace atelier::oracle {

/// The linear colour of a point as seen from `eye`:
///   kd ambient + emission + sum over lights of visibility * Arriving::amount * reflected(...)
/// A point without a normal, or with the eye upon it, has no direction to reflect in: ambient and emission are all.
/// Throws Error as `visibility` does.
glm::dvec3 shade(const World& world, const SurfacePoint& point, const glm::dvec3& eye, const Shading& shading,
                 Part part = Part::all);

/// The material of a point with its textures looked up.
Reflectance reflectance_at(const Scene& scene, const SurfacePoint& point);

}  // namespace atelier::oracle
