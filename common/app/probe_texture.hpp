// A probe of GLSL that reads a texture.
#pragma once

#include <functional>

#include "app/probe.hpp"
#include "gl/objects.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// The probe with a texture: for each call `make` gives one, which is bound to unit 0 as `kind` (GL_TEXTURE_2D,
/// GL_TEXTURE_2D_ARRAY, GL_TEXTURE_CUBE_MAP ...) while the probe runs. Filters reach across a cube's edges meanwhile.
Probe with_texture(GLenum kind, std::function<GlTexture(Gl& gl)> make, Probe probe);

/// The wrap mode of a probe's argument: 0 repeat, 1 mirrored_repeat, 2 clamp_to_edge.
inline Wrap wrap_of(int code) {
  return code == 0 ? Wrap::repeat : code == 1 ? Wrap::mirrored_repeat : Wrap::clamp_to_edge;
}

}  // namespace atelier
