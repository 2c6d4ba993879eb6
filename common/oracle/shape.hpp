// Exact curved shapes, as ground truth for tessellated ones. Each is a formula in its own object space, placed by a
// matrix.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <variant>

#include "oracle/ray.hpp"
#include "scene/scene.hpp"

namespace atelier::oracle {

/// A sphere around the origin, seen from outside. Texture coordinates as on make_sphere: u once around eastwards from
/// +x (counter-clockwise from above), v from the south pole to the north pole.
struct Sphere {
  double radius = 1;
};

/// The wall of an upright cylinder around the y axis, y from 0 to height, without floor and ceiling. Texture
/// coordinates as on make_cylinder_wall: u once around from +x, counter-clockwise from above if the wall faces out,
/// clockwise if it faces in; v up.
struct CylinderWall {
  double radius = 1, height = 1;
  bool inside = false;  ///< it faces the axis: a hall, not a column
};

/// The points centre + a half_u + b half_v, -1 <= a, b <= 1, facing half_u x half_v; u = (a + 1) / 2, v = (b + 1) / 2.
/// half_u and half_v are perpendicular.
struct Rectangle {
  glm::dvec3 centre{0}, half_u{1, 0, 0}, half_v{0, 0, -1};
};

using Surface = std::variant<Sphere, CylinderWall, Rectangle>;

/// A surface with its transform and material.
struct Shape {
  Surface surface;
  glm::dmat4 object_to_world{1};  ///< must be invertible; may rotate, scale (a sphere becomes an ellipsoid) and mirror
  int material = 0;               ///< index into Scene::materials
  bool casts_shadow = true, receives_shadow = true;
};

/// A surface point in the surface's own space.
struct ShapeHit {
  double t = 0;
  glm::dvec3 normal{0};  ///< of unit length, on the side that the surface faces
  glm::dvec2 texcoord{0};
};

/// The first intersection within the ray's interval, in the surface's own space. With `front_only`, back faces are
/// ignored.
std::optional<ShapeHit> intersect(const Surface& surface, const Ray& ray, bool front_only);

/// A bounding box of the shape in world space, slightly enlarged to allow for rounding.
Box3 bounds(const Shape& shape);

}  // namespace atelier::oracle
