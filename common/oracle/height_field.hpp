// Ray and height field. Over each square between four texel centres the surface is a bilinear patch, so the height
// above it along a ray is a quadratic in t, which is solved exactly. A ray walks through the squares that it crosses
// (Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987). Without gaps between neighbours: both
// use the same computed height above their common side, so a change of its sign is seen by one of them.
#pragma once

#include <optional>
#include <string>

#include "oracle/shape.hpp"

namespace atelier::oracle {

/// Throws Error that begins with `where`, such as "shape 3": no texture, an empty one or one with Filter::nearest (its
/// surface would be steps), a height outside 0..1, a depth that is negative or not finite, sides that are zero or not
/// perpendicular, a repeat outside (0, 1e4].
void validate(const HeightField& field, const std::string& where);

/// As for every surface, see shape.hpp. Nothing for a ray with a NaN or infinity, or one that runs within the surface.
/// The field must be valid.
std::optional<ShapeHit> intersect(const HeightField& field, const Ray& ray, bool front_only);

}  // namespace atelier::oracle
