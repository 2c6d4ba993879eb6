// 05-normal-mapping: the contract of normal_mapping.cpp, which runs once, on the CPU. You also write
// normal_mapping.glsl, which runs for every pixel: there the contract of each function is the comment above it.
//
// A normal map stores one direction per texel, in the space of the surface that it is stretched over (Blinn,
// "Simulation of wrinkled surfaces", 1978; Cohen, Olano and Manocha, "Appearance-preserving simplification", 1998):
//
//   texel c, 0..1  --decode-->  n in tangent space  --tangent frame-->  n in world space  -->  step 02's shade
//
// Tangent space has three axes: x runs along the surface in the direction in which the texture coordinate u grows, y in
// that of v, z is the normal of the surface. In a map, red is x, green is y (up: v grows upwards), blue is z.
//
// A tangent is a vec4. xyz has unit length and points along +u. w is the sign of the bitangent, which is not stored:
// B = w cross(N, T) points along +v. w is -1 where the texture is mirrored. This is how glTF 2.0 stores tangents too.
// (0, 0, 0, 0) means: there is no frame here, the surface is shaded as if it had no normal map.
//
// Mesh, Vertex and Wrap are declared in common/scene/scene.hpp, Image in common/image/image.hpp.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "02-blinn-phong/blinn_phong.hpp"

namespace atelier::normal_mapping {

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: tangents
// ---------------------------------------------------------------------------------------------------------------------

/// A corner of a triangle: object space, metres, and its texture coordinate.
struct Corner {
  glm::vec3 position{0};
  glm::vec2 texcoord{0};
};

/// The tangent of the triangle a, b, c, whose position is a linear function of its texture coordinate. xyz: the
/// direction in the triangle's plane in which u grows and v does not change. w: +1 where the texture is seen as it is
/// on the side from which a, b, c run counter-clockwise, -1 where it is seen mirrored.
/// (0, 0, 0, 0) for a degenerate triangle: twice its area is at most 1e-6 times the square of its longest edge, in
/// space or in texture coordinates; each of the two is measured in its own units. Lengths are 0 or 1e-18 to 1e18, in
/// both. Handout, section 2.
///
/// (0, 0, 0), (2, 0, 0), (0, 1, 0) with texture coordinates (0, 0), (1, 0), (0, 1): (1, 0, 0, 1). With texture
/// coordinates (0, 0), (0, 1), (1, 0) the tangent points along +y, and w is -1.
glm::vec4 triangle_tangent(const Corner& a, const Corner& b, const Corner& c);

/// The tangents of a mesh, one per vertex. Vertices that are listed apart stay apart, also where their positions are
/// equal. A vertex gets the mean of the tangents of its triangles:
/// - of every triangle that is not degenerate, the part of its tangent that is perpendicular to the vertex's normal, as
///   a vector of unit length (none where it is shorter than 1e-6), weighted by the triangle's angle at this vertex (so
///   that it does not matter into how many triangles a surface is cut);
/// - xyz is the sum, with unit length. It is perpendicular to the normal, which has unit length or is zero.
/// - w is -1 where the angles of the mirrored triangles have the larger sum, otherwise +1.
/// (0, 0, 0, 0) for a vertex that no triangle gives a direction: all its triangles are degenerate, or there is none, or
/// its normal is zero, or the directions cancel (their sum is shorter than 1e-4 of the sum of the weights). The order
/// of triangles and of their corners does not matter. Linear time. Handout, sections 3 and 4. You may call:
/// triangle_tangent.
std::vector<glm::vec4> vertex_tangents(const Mesh& mesh);

// ---------------------------------------------------------------------------------------------------------------------
// Core 2: maps
// ---------------------------------------------------------------------------------------------------------------------

/// The normal map of a height map. Red of `heights` is the height: 0 is the lowest, 1 the highest, and the picture is
/// one unit wide and one unit high, whatever its number of pixels. `depth` is the height of 1 in these units, and may
/// be negative or zero. The normal is that of the surface (u, v, depth h(u, v)), with the slopes from central
/// differences: from both neighbours of the texel, of which the wrap mode says what stands beyond the edge
/// (clamp_to_edge and mirrored_repeat: the edge's own texel; a side of one texel has no slope). The result has the size
/// of `heights`; a normal n of unit length is stored as n/2 + 1/2 in red, green and blue, alpha is 1. Row 0 of a
/// picture is its top row, v grows upwards. Handout, section 6.
///
/// A map of heights that grow by 0.25 from left to right over 4 texels of 16, with depth 0.5: a slope of 0.5,
/// hence n = (-0.447, 0, 0.894), stored as (0.276, 0.5, 0.947).
Image normals_from_heights(const Image& heights, float depth, Wrap wrap);

}  // namespace atelier::normal_mapping
