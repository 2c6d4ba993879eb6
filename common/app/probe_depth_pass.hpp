// Probes of a function that begins a pass which draws depths alone: a shadow map, a face of a cube.
#pragma once

#include <functional>

#include "app/probe.hpp"

namespace atelier {

/// The formats of depth that a probe's argument `format` counts: 16 and 24 bits, 32-bit floats. Throws
/// std::out_of_range for others.
GLenum depth_format_of(const Arguments& in);

/// What `begin` has set, after all of it was set otherwise: viewport (four numbers); depth test, function, writing and
/// clamping; culling and its face, 0 where nothing is culled. Afterwards no framebuffer is bound, and the state is as
/// reset_state leaves it.
Numbers depth_pass_state(Gl& gl, const std::function<void()>& begin);

}  // namespace atelier
