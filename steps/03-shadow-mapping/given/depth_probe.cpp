#include "03-shadow-mapping/given/depth_probe.hpp"

#include <array>

#include "gl/query.hpp"
#include "gl/state.hpp"

namespace atelier {

const std::string bias_as_argument =
    "#define u_bias u_other_bias\n#define u_depth_epsilon u_other_depth_epsilon\n"
    "#include \"03-shadow-mapping/given/shadows.glsl\"\n"
    "#undef u_bias\n#undef u_depth_epsilon\n";

GLenum depth_format_of(const Arguments& in) {
  constexpr std::array<GLenum, 3> formats{GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F};
  return formats.at(std::size_t(in.integer("format")));
}

void set_against_depth_pass(Gl& gl) {
  gl.Viewport(1, 1, 2, 2);
  gl.Disable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_GREATER);
  gl.DepthMask(GL_FALSE);
  gl.Disable(GL_DEPTH_CLAMP);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  gl.ClearDepth(0.25);
}

Numbers depth_pass_state(Gl& gl) {
  std::array<GLint, 4> viewport{};
  gl.GetIntegerv(GL_VIEWPORT, viewport.data());
  Numbers out(viewport.begin(), viewport.end());
  out.push_back(gl.IsEnabled(GL_DEPTH_TEST));
  out.push_back(integer_of(gl, GL_DEPTH_FUNC));
  out.push_back(integer_of(gl, GL_DEPTH_WRITEMASK));
  out.push_back(gl.IsEnabled(GL_DEPTH_CLAMP));
  out.push_back(gl.IsEnabled(GL_CULL_FACE));
  out.push_back(gl.IsEnabled(GL_CULL_FACE) ? integer_of(gl, GL_CULL_FACE_MODE) : 0);
  return out;
}

void end_depth_pass(Gl& gl) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  reset_state(gl);
}

}  // namespace atelier
