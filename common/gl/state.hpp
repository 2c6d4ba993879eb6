// The default OpenGL state.
#pragma once

#include "gl/gl.hpp"

namespace atelier {

/// Sets all state that a view, a pass, a probe or a student's function may have changed to its value in a new context:
///   tests of depth, stencil and scissor off; GL_LESS, GL_ALWAYS; depths and stencil bits written, colours too
///   clear values: transparent black, depth 1, stencil 0; depths -1..1 to 0..1, not clamped
///   no culling; if enabled, of back faces; counter-clockwise front faces; filled polygons without an offset
///   no blending, no clip distance, no conversion to sRGB, no program, no vertex array, texture unit 0 active
/// Framebuffer, viewport and textures do not change: code that draws must bind them.
void reset_state(Gl& gl);

}  // namespace atelier
