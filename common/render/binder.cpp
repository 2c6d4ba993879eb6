#include "render/feature.hpp"

namespace atelier {

void Binder::set(const std::string& name, float value) {
  if (const GLint at = uniforms_.location(name); at >= 0) gl_.Uniform1f(at, value);
}
void Binder::set(const std::string& name, int value) {
  if (const GLint at = uniforms_.location(name); at >= 0) gl_.Uniform1i(at, value);
}
void Binder::set(const std::string& name, const glm::vec2& value) {
  if (const GLint at = uniforms_.location(name); at >= 0) gl_.Uniform2fv(at, 1, &value.x);
}
void Binder::set(const std::string& name, const glm::vec3& value) {
  if (const GLint at = uniforms_.location(name); at >= 0) gl_.Uniform3fv(at, 1, &value.x);
}
void Binder::set(const std::string& name, const glm::vec4& value) {
  if (const GLint at = uniforms_.location(name); at >= 0) gl_.Uniform4fv(at, 1, &value.x);
}
void Binder::set(const std::string& name, const glm::mat3& value) {
  if (const GLint at = uniforms_.location(name); at >= 0) gl_.UniformMatrix3fv(at, 1, GL_FALSE, &value[0].x);
}
void Binder::set(const std::string& name, const glm::mat4& value) {
  if (const GLint at = uniforms_.location(name); at >= 0) gl_.UniformMatrix4fv(at, 1, GL_FALSE, &value[0].x);
}

void Binder::texture(const std::string& sampler, GLuint texture, GLenum target) {
  const GLint at = uniforms_.location(sampler);
  if (at < 0) return;
  gl_.ActiveTexture(GLenum(GL_TEXTURE0 + units_));
  gl_.BindTexture(target, texture);
  gl_.Uniform1i(at, units_++);
}

}  // namespace atelier
