#include "07-stencil-portals/stencil_portals.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace atelier::stencil_portals {

// TODO(07-stencil-portals): what your functions below share, if anything

glm::dmat4 portal_passage(const glm::dmat4& entry_to_world, const glm::dmat4& exit_to_world) {
  // TODO(07-stencil-portals): into the entry's frame, half a turn, out of the exit's frame
  return glm::dmat4(1);
}

glm::dmat4 mirror_passage(const glm::dmat4& mirror_to_world) {
  // TODO(07-stencil-portals): into the mirror's frame, turn z round, back
  return glm::dmat4(1);
}

glm::mat4 virtual_view(const glm::mat4& world_to_view, const glm::dmat4& passage) {
  // TODO(07-stencil-portals): where is a point of the other side, seen from here?
  return world_to_view;
}

glm::dvec4 opening_plane(const glm::dmat4& frame_to_world, bool from_behind) {
  // TODO(07-stencil-portals): the normal is the frame's z axis
  return glm::dvec4(0, 0, 0, 1);
}

void begin_mark(Gl& gl, int level) {
  // TODO(07-stencil-portals): count up where the level is right and the depth test passes
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl.DepthMask(GL_FALSE);
}

void begin_restore(Gl& gl, int level) {
  // TODO(07-stencil-portals): count down where the view was drawn, and put the opening's depth there
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl.DepthMask(GL_FALSE);
}

std::optional<glm::ivec4> opening_rectangle(std::span<const glm::vec4> corners, const glm::ivec2& size,
                                            const glm::ivec4& around) {
  // TODO(07-stencil-portals): cut the polygon at the picture's sides, then find its bounds in pixels
  return around;
}

bool goes_through(const glm::dmat4& frame_to_world, const glm::dvec2& half_size, const glm::dvec3& from,
                  const glm::dvec3& to) {
  // TODO(07-stencil-portals): in the opening's frame: from which side to which, and where does the line meet the plane?
  return false;
}

Camera carried(const Camera& camera, const glm::dmat4& passage) {
  // TODO(07-stencil-portals): two points and a direction
  return camera;
}

glm::vec4 plane_in_view(const glm::dvec4& plane_world, const glm::mat4& world_to_view) {
  // TODO(07-stencil-portals): planes are not points
  return glm::vec4(0, 0, 0, 1);
}

glm::mat4 oblique_projection(const glm::mat4& projection, const glm::vec4& plane_view) {
  // TODO(07-stencil-portals): a new third row: the plane, scaled, minus the fourth row
  return projection;
}

Light light_image(const Light& light, const glm::dmat4& passage) {
  // TODO(07-stencil-portals): a point and a direction
  return light;
}

bool stands_in(const glm::dmat4& frame_to_world, const glm::dvec2& half_size, std::span<const glm::dvec3, 8> corners) {
  // TODO(07-stencil-portals): in the opening's frame: on which sides of the plane, and of the rectangle, are the corners?
  return false;
}

}  // namespace atelier::stencil_portals
