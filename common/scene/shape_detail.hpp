// Shared by the shapes: parameter checks, points on circles, grids of quads.
#pragma once

#include <functional>
#include <string>

#include "scene/scene.hpp"

namespace atelier::shape_detail {

/// Throws Error "sphere: segments 2 (allowed: 3..4096)".
void require_count(const char* shape, const char* name, int value, int low, int high);
/// Throws Error unless 1e-6 <= value <= 1e6 metres; NaN fails too.
void require_length(const char* shape, const char* name, float value);

/// (cos, sin) of the i-th of n equal steps around a circle. Whole turns give the same bits (i = n equals i = 0), so
/// seams close; quarter turns are exact, so 4 steps give a square.
glm::dvec2 circle_point(int i, int n);

/// The corner (column, row) of a grid: column 0..columns, row 0..rows.
using GridVertex = std::function<Vertex(int column, int row)>;

/// Adds (columns + 1) x (rows + 1) vertices and two triangles per quad. Seen from the front, columns run to the right
/// and rows run up. Degenerate triangles are left out, as in add_triangle.
void add_grid(Mesh& mesh, int columns, int rows, const GridVertex& vertex);

/// Adds a triangle unless two of its corners have the same position.
void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c);

/// Adds the vertices and triangles of one mesh to another; both must have tangents, or neither.
void append(Mesh& mesh, const Mesh& other);

/// Flips normals and winding.
void turn_inside_out(Mesh& mesh);

}  // namespace atelier::shape_detail
