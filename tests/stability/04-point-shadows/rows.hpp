// The table of step 04, a function for each part of its contract.
#pragma once

#include "04-point-shadows/point_shadows.hpp"
#include "stability/rows.hpp"

namespace atelier::stability {

void add_face_rows(Table& table);
void add_cone_rows(Table& table);
void add_cube_rows(Table& table, ShaderFunctions& shaders);
void add_drawing_rows(Table& table, ShaderFunctions& shaders);
void add_lookup_rows(Table& table, ShaderFunctions& shaders);
void add_factor_rows(Table& table, ShaderFunctions& shaders);

/// What filled_cube takes for one distance all round.
inline constexpr std::array<float, 6> all_half{0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f};

/// Takes over a cube's objects, so that a row leaves nothing behind.
struct OwnedCube {
  OwnedCube(Gl& gl, const point_shadows::CubeMap& made);
  point_shadows::CubeMap names;
  GlTexture texture;
  GlFramebuffer framebuffer;
};

/// A cube made by the step's own function, with one distance in all texels of each face.
OwnedCube filled_cube(Gl& gl, int resolution, GLenum format, bool compare, const std::array<float, 6>& faces);

/// Which variant of the lookup: the defines that the program sets.
struct Lookup {
  int bias = 0, pcf = 1;
  bool compare = false;
};

/// An expression over the step's lookup functions, with one cube.
ShaderFunction lookup_function(std::vector<std::string> parameters, std::string expression, const Lookup& lookup = {});

/// Directions of 1 along its greatest component that lie on the cube's edges and corners, and up to `off` beside them
/// on each side: 12 edges at seven places each and 8 corners, nine of each.
std::vector<glm::vec3> directions_near_edges(float off);

}  // namespace atelier::stability
