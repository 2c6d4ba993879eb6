#include "gl/state.hpp"

namespace atelier {

namespace {

constexpr int clip_distances = 8;  // GL_MAX_CLIP_DISTANCES is at least this

void reset_depth_and_stencil(Gl& gl) {
  if (gl.ClipControl.call) gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_TRUE);
  gl.DepthRange(0, 1);
  gl.ClearDepth(1);
  gl.StencilFunc(GL_ALWAYS, 0, 0xff);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  gl.StencilMask(0xff);
  gl.ClearStencil(0);
}

}  // namespace

void reset_state(Gl& gl) {
  for (const GLenum what : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_DEPTH_CLAMP, GL_CULL_FACE, GL_POLYGON_OFFSET_FILL,
                            GL_BLEND, GL_SCISSOR_TEST, GL_FRAMEBUFFER_SRGB})
    gl.Disable(what);
  for (int i = 0; i < clip_distances; ++i) gl.Disable(GLenum(GL_CLIP_DISTANCE0 + i));
  reset_depth_and_stencil(gl);
  gl.CullFace(GL_BACK);
  gl.FrontFace(GL_CCW);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.ClearColor(0, 0, 0, 0);
  gl.UseProgram(0);
  gl.BindVertexArray(0);
  gl.ActiveTexture(GL_TEXTURE0);
}

}  // namespace atelier
