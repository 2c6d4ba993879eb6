// Procedural shapes. Each is a Mesh in its own object space (metres, +y up, counter-clockwise from outside) with unit
// normals and texture coordinates; each throws atelier::Error naming a parameter out of range.
//
//   Mesh globe = make_sphere({.radius = 0.5f, .segments = 64});
//
// Lengths are 1e-6 .. 1e6 metres, so that floats can hold their squares. Triangles without area (at the poles of a
// sphere) are left out; the two sides of a seam have bit-identical positions.
#pragma once

#include "scene/scene.hpp"

namespace atelier {

/// Whether normals and front faces point outwards or inwards.
enum class Side { outside, inside };

/// A UV sphere around the origin. u runs once around eastwards (counter-clockwise from above, from +x), v from the
/// south pole (0) to the north pole (1).
struct SphereShape {
  float radius = 1;
  int segments = 48;  ///< meridians, 3..4096
  int rings = 24;     ///< bands between the parallels, 2..4096
};
Mesh make_sphere(const SphereShape& shape = {});

/// A subdivided icosahedron: 20 * 4^subdivisions triangles of similar size, smooth normals. u and v by direction, as on
/// make_sphere; vertices are duplicated where u wraps around.
struct IcosphereShape {
  float radius = 1;
  int subdivisions = 1;  ///< 0..8
};
Mesh make_icosphere(const IcosphereShape& shape = {});

/// A torus around the y axis. u runs once around the axis, v once around the tube.
struct TorusShape {
  float ring_radius = 0.75f;  ///< from the axis to the middle of the tube
  float tube_radius = 0.25f;  ///< below ring_radius
  int segments = 64;          ///< around the axis, 3..4096
  int sides = 32;             ///< around the tube, 3..4096
};
Mesh make_torus(const TorusShape& shape = {});

/// A box around the origin: 24 vertices, four per face, for sharp edges. Each face shows the whole texture once.
struct BoxShape {
  glm::vec3 size{1};          ///< metres along x, y, z
  Side side = Side::outside;  ///< inside: a room
};
Mesh make_box(const BoxShape& shape = {});

/// A rectangle in the xz plane around the origin that faces +y. u runs along +x, v along -z: seen from above with -z
/// up, the texture is upright.
struct PlaneShape {
  float width = 1, depth = 1;  ///< metres along x and z
  glm::vec2 repeat{1};         ///< repetitions of the texture along u and v, 1e-3 .. 1e4
  int columns = 1, rows = 1;   ///< quads along x and z, 1..4096 (per-vertex lighting needs many)
};
Mesh make_plane(const PlaneShape& shape = {});

/// The wall of an upright cylinder of n flat sides: y from 0 to height, without floor and ceiling. The corners lie on
/// the circle, so the middle of a side is closer to the axis by R (1 - cos(pi / n)), the sagitta. Normals are those of
/// the circle (smooth). u runs once around: counter-clockwise from above if seen from outside, clockwise if seen from
/// inside, so that a texture is never mirrored; v runs up. One corner is at +x.
struct CylinderWallShape {
  float radius = 1, height = 1;
  int segments = 48;  ///< 3..65536
  Side side = Side::outside;
  glm::vec2 repeat{1};  ///< repetitions of the texture around and up, 1e-3 .. 1e4
};
Mesh make_cylinder_wall(const CylinderWallShape& shape = {});

/// A flat disc in the xz plane around the origin that faces +y, corners as in make_cylinder_wall. It shows the
/// texture's inscribed circle, upright as on make_plane.
struct DiscShape {
  float radius = 1;
  int segments = 48;  ///< 3..65536
};
Mesh make_disc(const DiscShape& shape = {});

/// A closed cylinder, y from 0 to height: wall, bottom and top with sharp edges.
struct CylinderShape {
  float radius = 1, height = 1;
  int segments = 48;  ///< 3..65536
};
Mesh make_cylinder(const CylinderShape& shape = {});

/// A closed cone with its base on y = 0 and its tip on the y axis. The side has the exact cone's normals; the tip is
/// one vertex per segment, each with the normal of the middle of its segment.
struct ConeShape {
  float radius = 1, height = 1;
  int segments = 48;  ///< 3..32768
};
Mesh make_cone(const ConeShape& shape = {});

/// Newell's teapot of 1975 from its 32 bicubic patches: it stands on y = 0 around the y axis with the spout towards +x.
/// Not closed: the lid leaves a gap, and spout and handle extend through the body. u runs once around each part, v up
/// or along it.
struct TeapotShape {
  float height = 1;       ///< metres to the knob's top; its length is 2.07 times its height
  int subdivisions = 10;  ///< quads along a patch's side, 2..64 (with 1, handle and spout would be flat)
};
Mesh make_teapot(const TeapotShape& shape = {});

}  // namespace atelier
