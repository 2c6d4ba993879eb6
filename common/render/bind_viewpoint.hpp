// What every program that draws nodes for a view is told of it.
#pragma once

#include "render/binder.hpp"
#include "render/view.hpp"

namespace atelier {

/// Sets u_view, u_projection, u_eye_world and, where the view is clipped, u_clip_plane.
void bind_viewpoint(Binder& binder, const Viewpoint& viewpoint);

}  // namespace atelier
