// 01-transforms: the contract of transforms.cpp. The contract of each function of transforms.glsl is the comment above
// it in that file. The handout derives the formulas.
//
// Conventions of the whole course
//   Points and directions are column vectors; matrices multiply from the left: p' = M p. glm stores columns: m[3] is
//   the fourth. Right-handed space, +y up. The camera looks along -z of its own (view) space. Positions have w = 1,
//   directions w = 0. Angles are in radians, lengths in metres. The path of a vertex: object --model--> world --view-->
//   view --projection--> clip --divide by w--> -1..1 in x, y, z.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/transforms.hpp"

namespace atelier::transforms {

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: matrices that move, turn and stretch
// ---------------------------------------------------------------------------------------------------------------------

/// Translates every point by `offset`; does not change directions (w = 0).
glm::mat4 translation(const glm::vec3& offset);

/// Rotates about `axis` through the origin by `angle` radians, counter-clockwise for a viewer whom the axis points at
/// (Rodrigues: R = cos I + sin [a]x + (1 - cos) a a^T, with a the unit axis). The axis may have any length
/// from 1e-18 to 1e18 (beyond that, squares leave the range of a float); an axis of length zero gives the identity.
glm::mat4 rotation(const glm::vec3& axis, float angle);

/// Multiplies x, y and z by the factors, which may be negative or zero.
glm::mat4 scaling(const glm::vec3& factors);

/// Scales first, then rotates, then translates: the order for placing a node of a scene.
glm::mat4 compose(const glm::vec3& offset, const glm::vec3& axis, float angle, const glm::vec3& factors);

/// World matrices of a hierarchy, in the order of `joints`. A root's is its own local matrix; a child's is its parent's
/// world matrix times its own local matrix. Parents may be listed before or after their children; chains may be
/// thousands deep (do not recurse once per level). Throws std::invalid_argument if a parent is outside -1 .. size-1, or
/// if parents form a cycle.
std::vector<glm::mat4> world_matrices(std::span<const Joint> joints);

// ---------------------------------------------------------------------------------------------------------------------
// Core 2: the camera
// ---------------------------------------------------------------------------------------------------------------------

/// The view matrix of a camera at `eye` that looks at `target` with `up` pointing upwards in the picture: maps the eye
/// to the origin and the viewing direction to -z, and preserves lengths and angles. `up` need not be a unit vector (its
/// length is 1e-18 to 1e18) nor perpendicular to the viewing direction; within a thousandth of that direction, floats
/// no longer keep the three axes perpendicular. If up is parallel to the viewing direction (or zero), it is replaced by
/// the axis, x, y or z, along which the viewing direction has the smallest |component|; of several, the first in this
/// order. If eye = target, the camera looks along -z.
glm::mat4 look_at(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up);

/// Perspective with the full vertical angle `fov_y` (radians) and aspect = width / height; the planes at distance
/// `near` and `far` in front of the eye get depth -1 and +1. Throws std::invalid_argument unless 0 < fov_y <= 179
/// degrees (at 180 the tangent is infinite, and in floats even negative: the picture would be mirrored), aspect > 0,
/// 0 < near < far. Not for an infinite far: use perspective_reversed for that.
glm::mat4 perspective(float fov_y, float aspect, float near, float far);

/// Maps the box left..right, bottom..top, -near..-far of view space to the cube -1..1. Near may be negative. Throws
/// std::invalid_argument if two opposite sides are equal.
glm::mat4 orthographic(float left, float right, float bottom, float top, float near, float far);

// ---------------------------------------------------------------------------------------------------------------------
// Core 3: normals
// ---------------------------------------------------------------------------------------------------------------------

/// The matrix that transforms normals: sign(det M) cofactor(M) of the upper left 3x3 block M, or any positive multiple
/// of it (normals are normalised afterwards). It equals the inverse transpose times |det M|, but needs no division and
/// so exists for flattened models too; the sign of a determinant of zero is +. Right for every finite model, even where
/// products of its entries overflow a float, or underflow to 0: diag(1e25, 1, -1) turns (1, 1, 0) into (0, 1, 0).
glm::mat3 normal_matrix(const glm::mat4& model);

// ---------------------------------------------------------------------------------------------------------------------
// Core 4: vertex buffers. `gl.Xyz(...)` is OpenGL's glXyz(...). Both leave no vertex array bound.
// ---------------------------------------------------------------------------------------------------------------------

/// Three positions, drawn without indices: a vertex array, one buffer with 9 floats, attribute_position read from it.
/// Returns count 3 and no index buffer.
MeshBuffers upload_triangle(Gl& gl, std::span<const glm::vec3, 3> positions);

/// A whole mesh: a vertex array, one buffer with the vertices unchanged (interleaved), attribute_position,
/// attribute_normal and attribute_texcoord read from it by stride and offset, and one buffer of indices that the vertex
/// array stores. Returns count = number of indices.
MeshBuffers upload_mesh(Gl& gl, std::span<const Vertex> vertices, std::span<const std::uint32_t> indices);

// ---------------------------------------------------------------------------------------------------------------------
// Further: a hall, wireframes, and where a pixel lies
// ---------------------------------------------------------------------------------------------------------------------

/// The wall of a cylindrical hall about the y axis from y = 0 to y = height, seen from INSIDE, in `segments` flat
/// pieces. Vertices: for i = 0 .. segments, angle phi = 2 pi i / segments, first the lower (y = 0), then the upper (y =
/// height) at (radius cos phi, y, radius sin phi), normal towards the axis, texcoord (i / segments, y / height): 2
/// (segments + 1) in all, because the seam has two values of u. The last pair is exactly at the first. Each piece is
/// two triangles, counter-clockwise seen from the axis, over its lower-left, lower-right, upper-right, upper-left
/// corner as seen from inside (the diagonal goes from lower left to upper right). Throws std::invalid_argument unless
/// radius > 0, height > 0, segments >= 3.
Mesh cylinder_wall(float radius, float height, int segments);

/// A flat rectangle centre +- half_u +- half_v with the unit normal along half_u x half_v: four vertices in the order
/// (-u-v), (+u-v), (+u+v), (-u+v) with texcoords (0,0), (1,0), (1,1), (0,1), and two triangles that share the diagonal
/// from the first to the third. The hall's floor and ceiling are such squares; the wall hides their corners.
Mesh rectangle(const glm::vec3& centre, const glm::vec3& half_u, const glm::vec3& half_v);

/// Sets the mode: from now on triangles are drawn as edges (on), or filled (off).
void set_wireframe(Gl& gl, bool on);

/// Where a clip-space point appears: x and y in pixels from the lower left corner of the viewport (x, y, width,
/// height), z as depth 0..1. This is what OpenGL does after your vertex shader. Requires w > 0.
glm::vec3 window_position(const glm::vec4& clip, const glm::vec4& viewport);

// ---------------------------------------------------------------------------------------------------------------------
// Challenge: far and wide
// ---------------------------------------------------------------------------------------------------------------------

/// Like `perspective`, for a clip space whose depth goes from 0 to 1 (glClipControl), reversed: 1 at the near plane and
/// 0 at the far plane, depth = n (f - z) / (z (f - n)) at distance z. An infinite `far` is allowed: depth = n / z.
/// Throws as `perspective` does.
glm::mat4 perspective_reversed(float fov_y, float aspect, float near, float far);

/// `position` relative to `eye`, as floats: the difference is computed in double precision, *before* anything is
/// rounded. A million metres from the origin a float resolves positions only to 6 cm; the difference loses nothing.
glm::vec3 relative_to_eye(const glm::dvec3& position, const glm::dvec3& eye);

}  // namespace atelier::transforms
