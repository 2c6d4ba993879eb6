// Draws the colour of a target into a part of the window, encoded for the screen.
#pragma once

#include <glm/glm.hpp>

#include "app/step_program.hpp"
#include "gl/objects.hpp"
#include "gl/target.hpp"

namespace atelier {

/// A part of a framebuffer in pixels, from the lower left corner as in OpenGL.
struct PixelArea {
  glm::ivec2 corner{0}, size{1};
};

class Presenter {
 public:
  explicit Presenter(Gl& gl);

  /// Fills `area` of the bound framebuffer, pixel for pixel if it has the target's size. Linear colours are encoded to
  /// sRGB (IEC 61966-2-1), others are unchanged; all are clamped to 0..1. NaN and infinity are shown as magenta. (An
  /// 8-bit target cannot store them; the renderer writes magenta into it.)
  void draw(const Target& picture, Encoding encoding, const PixelArea& area);

 private:
  Gl& gl_;
  GlProgram program_;
};

/// Reads the bound framebuffer, without decoding, row 0 at the top.
Image read_framebuffer(Gl& gl, glm::ivec2 size);

}  // namespace atelier
