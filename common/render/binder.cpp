#include "render/binder.hpp"

namespace atelier {

void Binder::texture(const std::string& sampler, GLuint texture, GLenum target) {
  if (uniforms_.location(sampler) < 0) return;  // the driver removed it: keep the unit for one that is used
  gl_.ActiveTexture(GLenum(GL_TEXTURE0 + units_));
  gl_.BindTexture(target, texture);
  uniforms_.set(sampler, units_++);
}

}  // namespace atelier
