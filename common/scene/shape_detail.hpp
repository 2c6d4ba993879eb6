// What the shapes share: checks of their measures, points on circles, grids of quads.
#pragma once

#include <functional>
#include <string>

#include "scene/scene.hpp"

namespace atelier::shape_detail {

/// Throws Error "sphere: segments 2 (allowed: 3..4096)".
void require_count(const char* shape, const char* name, int value, int low, int high);
/// Throws Error unless 1e-6 <= value <= 1e6 metres; NaN fails too.
void require_length(const char* shape, const char* name, float value);

/// (cos, sin) of the i-th of n equal steps around a circle. Whole turns give the same bits (i = n is i = 0), and
/// quarter turns are exact: seams close, and a box's worth of a circle is a square.
glm::dvec2 circle_point(int i, int n);

/// The corner (column, row) of a grid: column 0..columns, row 0..rows.
using GridVertex = std::function<Vertex(int column, int row)>;

/// Adds (columns + 1) x (rows + 1) vertices and two triangles a quad. The front is where columns run to the right and
/// rows run up. Triangles whose corners do not have three different positions are left out.
void add_grid(Mesh& mesh, int columns, int rows, const GridVertex& vertex);

/// Adds a triangle unless two of its corners lie at the same place.
void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c);

/// Adds the vertices and triangles of one mesh to another; both have tangents, or none has.
void append(Mesh& mesh, const Mesh& other);

/// Turns the surface inside out: normals and winding.
void turn_inside_out(Mesh& mesh);

}  // namespace atelier::shape_detail
