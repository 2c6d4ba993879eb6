// The uniforms of a view.
#pragma once

#include "render/binder.hpp"
#include "render/view.hpp"

namespace atelier {

/// Sets u_view, u_projection, u_eye_world and, if the view has a clip plane, u_clip_plane.
void bind_viewpoint(Binder& binder, const Viewpoint& viewpoint);

}  // namespace atelier
