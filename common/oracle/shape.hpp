// Exact curved shapes, as ground truth for tessellated ones. Each is a formula in its own object space, placed by a
// matrix.
#pragma once

#include <glm/glm.hpp>
#include <memory>
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
/// coordinates as on make_cylinder_wall: u from 0 to `repeat` around, from +x, counter-clockwise from above if the wall
/// faces out, clockwise if it faces in; v up.
struct CylinderWall {
  double radius = 1, height = 1;
  bool inside = false;  ///< it faces the axis: a hall, not a column
  double repeat = 1;    ///< of the texture around it
};

/// The points centre + a half_u + b half_v, -1 <= a, b <= 1, facing half_u x half_v; u = (a + 1) / 2, v = (b + 1) / 2.
/// half_u and half_v are perpendicular.
struct Rectangle {
  glm::dvec3 centre{0}, half_u{1, 0, 0}, half_v{0, 0, -1};
};

/// A rectangle whose points lie below its plane: at texture coordinate (u, v) by depth (1 - h(u, v)), where h is red of
/// `heights` as its sampler gives it: bilinear between texel centres, with its wrap mode. A sheet that faces like the
/// rectangle, without walls at its sides. oracle/height_field.hpp says what is valid; a World checks it.
struct HeightField {
  Rectangle flat;
  std::shared_ptr<const Texture> heights;  ///< red 0..1; Filter::linear or Filter::mipmap
  double depth = 0;                        ///< metres in the surface's own space, 0 or more
  glm::dvec2 repeat{1};  ///< texture coordinates at (a, b) of the rectangle: ((a + 1) / 2, (b + 1) / 2) repeat
  /// Whether the surface ends at the rectangle's sides, and rays leave through them. Otherwise it goes on behind the
  /// sides, seen through the rectangle as through a window: a ray that comes over the rectangle, at most `depth` below
  /// its plane, also meets what lies farther along it, to 100 half sides from the centre. A ray that starts beyond the
  /// sides and does not come over the rectangle meets nothing, so the part behind them casts no shadow on itself.
  bool edges = true;
  /// Whether it is seen through the rectangle alone: a ray that begins above the rectangle's plane and does not cross
  /// it within the rectangle meets nothing.
  bool window = false;
};

using Surface = std::variant<Sphere, CylinderWall, Rectangle, HeightField>;

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

/// A bounding box of the shape in world space, slightly enlarged to allow for rounding. What a height field without
/// edges has behind its sides is outside; a ray that meets it passes the box before.
Box3 bounds(const Shape& shape);

}  // namespace atelier::oracle
