// Tangents after the standard of normal maps, MikkTSpace: with any others, a map baked by another program shows seams.
#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// Tangents for each corner, in the order of mesh.indices: xyz in object space, of unit length, along +u in the plane
/// perpendicular to the corner's normal; w is 1, or -1 where the texture is mirrored, so that +v is along
/// w cross(normal, xyz).
///
/// Triangles around a vertex share a tangent if they are connected by edges, have the same position, normal and texture
/// coordinate there (whether or not they share the vertex in the mesh), and are all mirrored or all not mirrored. It is
/// the mean of their directions, weighted by their angles. Triangles without an area in the texture share their
/// neighbours' tangents, those with two corners at one place those of any other triangle at the same vertex. What has
/// no such neighbour gets the standard's default, (1, 0, 0, -1), whatever its normal; where a mean is zero or not
/// finite, xyz is (1, 0, 0).
///
/// The order of the triangles matters only where the standard lets it decide: if more than two triangles share an edge,
/// where triangles without an area in the texture or in space touch both mirrored and unmirrored ones, and by rounding
/// where the directions cancel out, as at the pole of a sphere.
///
/// The algorithm: Mikkelsen, "Simulation of wrinkled surfaces revisited", 2008, and the comments of his mikktspace.h,
/// with the angle threshold of 180 degrees: exactly opposite directions are not averaged, except where more than 512
/// triangles share a tangent. What decides is computed as there, in single precision. `mesh` must have
/// indices below vertices.size(); its tangents are not read. Time n log n, no recursion.
std::vector<glm::vec4> standard_tangents(const Mesh& mesh);

}  // namespace atelier
