// The uniforms of a view.
#pragma once

#include "render/binder.hpp"
#include "render/view.hpp"

namespace atelier {

/// A plane of the world in the shaders' world space, from which `origin` is subtracted (Viewpoint::origin).
glm::vec4 moved_plane(const glm::dvec4& plane, const glm::dvec3& origin);

/// Sets u_view, u_projection, u_eye_world and, if the view has a clip plane, u_clip_plane.
void bind_viewpoint(Binder& binder, const Viewpoint& viewpoint);

}  // namespace atelier
