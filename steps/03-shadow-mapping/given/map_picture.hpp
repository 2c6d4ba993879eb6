// A shadow map as a picture. Given.
#pragma once

#include <functional>
#include <string>

#include "gl/shader.hpp"
#include "gl/target.hpp"

namespace atelier {

/// Draws a depth texture over a whole target, texel by texel. The program is built at first use.
class MapPicture {
 public:
  /// `kind` is the texture's target, GL_TEXTURE_2D_ARRAY or GL_TEXTURE_CUBE_MAP; `fragment` the GLSL that reads it:
  /// declares `u_map` and optionally `uniform vec2 u_size` (the target's pixels), and writes `out vec4 o`.
  MapPicture(GLenum kind, std::string fragment) : kind_(kind), fragment_(std::move(fragment)) {}

  /// Reads the texture without comparison and filtering, and restores its parameters. `bind` sets further uniforms.
  void draw(Gl& gl, const Target& target, GLuint texture, const std::function<void(Uniforms&)>& bind = {});

 private:
  GLenum kind_;
  std::string fragment_;
  GlProgram program_;
};

}  // namespace atelier
