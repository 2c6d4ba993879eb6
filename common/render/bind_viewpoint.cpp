#include "render/bind_viewpoint.hpp"

namespace atelier {

glm::vec4 moved_plane(const glm::dvec4& plane, const glm::dvec3& origin) {
  return glm::vec4(glm::dvec4(glm::dvec3(plane), plane.w + glm::dot(glm::dvec3(plane), origin)));
}

void bind_viewpoint(Binder& binder, const Viewpoint& viewpoint) {
  binder.set("u_view", viewpoint.world_to_view);
  binder.set("u_projection", viewpoint.projection);
  binder.set("u_eye_world", viewpoint.eye);
  if (const auto& plane = viewpoint.view.clip_plane) binder.set("u_clip_plane", moved_plane(*plane, viewpoint.origin));
}

}  // namespace atelier
