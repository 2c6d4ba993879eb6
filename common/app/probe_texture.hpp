// A probe of GLSL that reads a texture.
#pragma once

#include <functional>

#include "app/probe.hpp"
#include "gl/objects.hpp"

namespace atelier {

/// The probe with a texture: for each call `make` gives one, which is bound to unit 0 as `kind` (GL_TEXTURE_2D,
/// GL_TEXTURE_2D_ARRAY, GL_TEXTURE_CUBE_MAP ...) while the probe runs. Filters reach across a cube's edges meanwhile.
Probe with_texture(GLenum kind, std::function<GlTexture(Gl& gl)> make, Probe probe);

}  // namespace atelier
