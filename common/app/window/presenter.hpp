// From linear light to the screen: draws the colour of a target into a part of the window.
#pragma once

#include <glm/glm.hpp>

#include "app/step_program.hpp"
#include "gl/objects.hpp"
#include "gl/target.hpp"

namespace atelier {

/// A part of a framebuffer in pixels, from the lower left corner as OpenGL counts.
struct PixelArea {
  glm::ivec2 corner{0}, size{1};
};

class Presenter {
 public:
  explicit Presenter(Gl& gl);

  /// Fills `area` of the framebuffer that is bound, pixel for pixel where it has the target's size. Linear colours are
  /// encoded to sRGB (IEC 61966-2-1), the others shown as they are; all are clamped to 0..1. What is no number or
  /// infinite shows as magenta: nothing else would tell. (A target of 8 bits holds no such thing; the renderer writes
  /// magenta into it.)
  void draw(const Target& picture, Encoding encoding, const PixelArea& area);

 private:
  Gl& gl_;
  GlProgram program_;
};

/// What the framebuffer that is bound shows, encoded as it is, row 0 at the top.
Image read_framebuffer(Gl& gl, glm::ivec2 size);

}  // namespace atelier
