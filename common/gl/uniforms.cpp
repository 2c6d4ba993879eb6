#include "gl/shader.hpp"

namespace atelier {

GLint Uniforms::location(std::string_view name) {
  auto found = locations_.find(name);
  if (found == locations_.end()) {
    const std::string key(name);
    found = locations_.emplace(key, gl_->GetUniformLocation(program_, key.c_str())).first;
  }
  return found->second;
}

// OpenGL ignores location -1, so a name that the program does not use needs no test here.
void Uniforms::set(std::string_view name, int value) {
  gl_->Uniform1i(location(name), value);
}
void Uniforms::set(std::string_view name, float value) {
  gl_->Uniform1f(location(name), value);
}
void Uniforms::set(std::string_view name, const glm::vec2& value) {
  gl_->Uniform2fv(location(name), 1, &value.x);
}
void Uniforms::set(std::string_view name, const glm::vec3& value) {
  gl_->Uniform3fv(location(name), 1, &value.x);
}
void Uniforms::set(std::string_view name, const glm::vec4& value) {
  gl_->Uniform4fv(location(name), 1, &value.x);
}
void Uniforms::set(std::string_view name, const glm::mat3& value) {
  gl_->UniformMatrix3fv(location(name), 1, GL_FALSE, &value[0].x);
}
void Uniforms::set(std::string_view name, const glm::mat4& value) {
  gl_->UniformMatrix4fv(location(name), 1, GL_FALSE, &value[0].x);
}

}  // namespace atelier
