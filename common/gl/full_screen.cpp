#include "gl/full_screen.hpp"

#include "gl/objects.hpp"

namespace atelier {

void draw_triangle_by_id(Gl& gl) {
  const GlVertexArray no_attributes(gl);  // a core context draws nothing without one
  gl.BindVertexArray(no_attributes.id());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.BindVertexArray(0);
}

}  // namespace atelier
