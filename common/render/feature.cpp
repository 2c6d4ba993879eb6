#include <tuple>

#include "render/feature.hpp"

namespace atelier {

void Binder::texture(const std::string& sampler, GLuint texture, GLenum target) {
  if (uniforms_.location(sampler) < 0) return;  // the driver removed it: keep the unit for one that is used
  gl_.ActiveTexture(GLenum(GL_TEXTURE0 + units_));
  gl_.BindTexture(target, texture);
  uniforms_.set(sampler, units_++);
}

bool PassSources::operator<(const PassSources& other) const {
  return std::tie(vertex, geometry, fragment, structure) <
         std::tie(other.vertex, other.geometry, other.fragment, other.structure);
}

}  // namespace atelier
