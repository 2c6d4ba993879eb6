// How a feature sets the uniforms and textures of a program.
#pragma once

#include <string>
#include <string_view>

#include "gl/shader.hpp"

namespace atelier {

/// Sets uniforms and textures of the current program, and assigns the texture units.
class Binder {
 public:
  Binder(Gl& gl, Uniforms& uniforms) : gl_(gl), uniforms_(uniforms) {}
  /// A float, int, vector or matrix. A name that this program does not use is ignored.
  template <class Value>
  void set(std::string_view name, const Value& value) {
    uniforms_.set(name, value);
  }
  /// Binds a texture to the next free unit and points the sampler at it.
  void texture(const std::string& sampler, GLuint texture, GLenum target = GL_TEXTURE_2D);

 private:
  Gl& gl_;
  Uniforms& uniforms_;
  int units_ = 0;
};

}  // namespace atelier
