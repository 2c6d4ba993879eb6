// What a step teaches of views inside views, from a library's point of view: the usual two stencil states.
#pragma once

#include "render/renderer.hpp"

namespace atelier::test {

inline NestingFunctions nesting() {
  return {.begin_mark =
              [](Gl& gl, int level) {
                gl.Enable(GL_STENCIL_TEST);
                gl.StencilFunc(GL_EQUAL, level, 0xff);
                gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
                gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
                gl.DepthMask(GL_FALSE);
              },
          .begin_restore =
              [](Gl& gl, int level) {
                gl.Enable(GL_STENCIL_TEST);
                gl.StencilFunc(GL_EQUAL, level + 1, 0xff);
                gl.StencilOp(GL_KEEP, GL_KEEP, GL_DECR);
                gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
                gl.DepthFunc(GL_ALWAYS);
              }};
}

}  // namespace atelier::test
