#include "app/probe_depth_pass.hpp"

#include <array>

#include "gl/query.hpp"
#include "gl/state.hpp"

namespace atelier {

namespace {

/// All that such a pass must set.
void set_otherwise(Gl& gl) {
  gl.Viewport(1, 1, 2, 2);
  gl.Disable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_GREATER);
  gl.DepthMask(GL_FALSE);
  gl.Disable(GL_DEPTH_CLAMP);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  gl.ClearDepth(0.25);
}

}  // namespace

GLenum depth_format_of(const Arguments& in) {
  constexpr std::array<GLenum, 3> formats{GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F};
  return formats.at(std::size_t(in.integer("format")));
}

Numbers depth_pass_state(Gl& gl, const std::function<void()>& begin) {
  set_otherwise(gl);
  begin();
  std::array<GLint, 4> viewport{};
  gl.GetIntegerv(GL_VIEWPORT, viewport.data());
  Numbers out(viewport.begin(), viewport.end());
  out.push_back(gl.IsEnabled(GL_DEPTH_TEST));
  out.push_back(integer_of(gl, GL_DEPTH_FUNC));
  out.push_back(integer_of(gl, GL_DEPTH_WRITEMASK));
  out.push_back(gl.IsEnabled(GL_DEPTH_CLAMP));
  out.push_back(gl.IsEnabled(GL_CULL_FACE));
  out.push_back(gl.IsEnabled(GL_CULL_FACE) ? integer_of(gl, GL_CULL_FACE_MODE) : 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  reset_state(gl);
  return out;
}

}  // namespace atelier
