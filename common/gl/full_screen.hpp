// One triangle over everything: how a fragment shader is run for each pixel of a target.
#pragma once

#include "gl/gl.hpp"

namespace atelier {

/// A vertex shader without attributes: corners (-1, -1), (3, -1), (-1, 3) of clip space, 0 deep, and `v_texcoord`, a
/// vec2 from 0 to 1 across the target. A square of two triangles would shade the pixels along its diagonal twice.
inline constexpr const char* full_screen_vertex_text = R"(
out vec2 v_texcoord;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  v_texcoord = corner * 0.5 + 0.5;
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

/// Draws one triangle without attributes with the program in use, whose vertex shader makes its corners of gl_VertexID:
/// 0, 1 and 2. No vertex array is bound afterwards.
void draw_triangle_by_id(Gl& gl);

}  // namespace atelier
