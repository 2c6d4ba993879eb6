// The colour of a surface point, lit by all lights of the scene.
#pragma once

#include "oracle/shading.hpp"

namespace atelier::oracle {

/// The linear colour of a point as seen from `eye`:
///   kd ambient + emission + sum over lights of visibility * Arriving::amount * reflected(...)
/// Images of lights in portals and mirrors count as lights if the shading says so.
/// A point without a normal, or at the eye, has only ambient and emitted light. Throws Error as `visibility` does.
glm::dvec3 shade(const World& world, const SurfacePoint& point, const glm::dvec3& eye, const Shading& shading,
                 Part part = Part::all);

/// The material of a point with its textures applied.
Reflectance reflectance_at(const Scene& scene, const SurfacePoint& point);

}  // namespace atelier::oracle
