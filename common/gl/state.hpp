// The state of OpenGL that drawing starts from.
#pragma once

#include "gl/gl.hpp"

namespace atelier {

/// Sets everything that a view, a pass, a probe or a student's function may have left otherwise to what it is in a new
/// context, in one list:
///   tests of depth, stencil and scissor off; GL_LESS, GL_ALWAYS; depths and stencil bits written, colours too
///   clear values: transparent black, depth 1, stencil 0; depths -1..1 to 0..1, not clamped
///   nothing culled, back faces where asked for, counter-clockwise fronts, filled polygons without an offset
///   no blending, no clip distance, no conversion to sRGB, no program, no vertex array, texture unit 0 active
/// Framebuffer, viewport and textures stay: whoever draws binds them.
void reset_state(Gl& gl);

}  // namespace atelier
