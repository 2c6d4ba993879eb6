#include "app/probe_texture.hpp"

namespace atelier {

namespace {

/// Bound to unit 0 as long as this lives.
class BoundTexture {
 public:
  BoundTexture(Gl& gl, GLenum kind, GlTexture texture)
      : gl_(gl),
        kind_(kind),
        texture_(std::move(texture)),
        seamless_before_(gl.IsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS)) {
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(kind, texture_.id());
    gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  }
  ~BoundTexture() {
    gl_.BindTexture(kind_, 0);
    if (!seamless_before_) gl_.Disable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  }
  BoundTexture(const BoundTexture&) = delete;
  BoundTexture& operator=(const BoundTexture&) = delete;

 private:
  Gl& gl_;
  GLenum kind_;
  GlTexture texture_;
  bool seamless_before_;
};

}  // namespace

Probe with_texture(GLenum kind, std::function<GlTexture(Gl& gl)> make, Probe probe) {
  return [kind, make = std::move(make), probe = std::move(probe)](ProbeContext& context, const Arguments& in) {
    const BoundTexture bound(context.gl, kind, make(context.gl));
    return probe(context, in);
  };
}

}  // namespace atelier
