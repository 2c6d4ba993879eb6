#include "render/binder.hpp"

namespace atelier {

void Binder::texture(const std::string& sampler, GLuint texture, GLenum target) {
  if (uniforms_.location(sampler) < 0) return;  // unused in this program: do not spend a unit on it
  gl_.ActiveTexture(GLenum(GL_TEXTURE0 + units_));
  gl_.BindTexture(target, texture);
  uniforms_.set(sampler, units_++);
}

}  // namespace atelier
