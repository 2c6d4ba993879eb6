#include "07-stencil-portals/stencil_portals.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace atelier::stencil_portals {

// >>> student: what your functions below share, if anything
namespace {

/// Of a frame, which only rotates and translates.
glm::dmat4 inverse_of(const glm::dmat4& frame_to_world) {
  const glm::dmat3 turn = glm::transpose(glm::dmat3(frame_to_world));
  glm::dmat4 inverse(turn);
  inverse[3] = glm::dvec4(-(turn * glm::dvec3(frame_to_world[3])), 1);
  return inverse;
}

/// The part of a convex polygon where dot(side, p) >= 0.
std::vector<glm::dvec4> part_inside(const std::vector<glm::dvec4>& polygon, const glm::dvec4& side) {
  std::vector<glm::dvec4> inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec4 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = glm::dot(side, a), at_b = glm::dot(side, b);
    if (at_a >= 0) inside.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) inside.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return inside;
}

}  // namespace
// --- skeleton
// <<< student

glm::dmat4 portal_passage(const glm::dmat4& entry_to_world, const glm::dmat4& exit_to_world) {
  // >>> student: into the entry's frame, half a turn, out of the exit's frame
  const glm::dmat4 half_turn(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1);
  return exit_to_world * half_turn * inverse_of(entry_to_world);
  // --- skeleton
  // | return glm::dmat4(1);
  // <<< student
}

glm::dmat4 mirror_passage(const glm::dmat4& mirror_to_world) {
  // >>> student: into the mirror's frame, turn z round, back
  const glm::dmat4 flip(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1);
  return mirror_to_world * flip * inverse_of(mirror_to_world);
  // --- skeleton
  // | return glm::dmat4(1);
  // <<< student
}

glm::mat4 virtual_view(const glm::mat4& world_to_view, const glm::dmat4& passage) {
  // >>> student: where is a point of the other side, seen from here?
  return glm::mat4(glm::dmat4(world_to_view) * glm::inverse(passage));
  // --- skeleton
  // | return world_to_view;
  // <<< student
}

glm::dvec4 opening_plane(const glm::dmat4& frame_to_world, bool from_behind) {
  // >>> student: the normal is the frame's z axis
  const glm::dvec3 normal(frame_to_world[2]), origin(frame_to_world[3]);
  const glm::dvec4 plane(normal, -glm::dot(normal, origin));
  return from_behind ? -plane : plane;
  // --- skeleton
  // | return glm::dvec4(0, 0, 0, 1);
  // <<< student
}

void begin_mark(Gl& gl, int level) {
  // >>> student: count up where the level is right and the depth test passes
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilFunc(GL_EQUAL, level, 0xff);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl.DepthMask(GL_FALSE);
  // --- skeleton
  // | gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  // | gl.DepthMask(GL_FALSE);
  // <<< student
}

void begin_restore(Gl& gl, int level) {
  // >>> student: count down where the view was drawn, and put the opening's depth there
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilFunc(GL_EQUAL, level + 1, 0xff);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_DECR);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl.DepthFunc(GL_ALWAYS);
  // --- skeleton
  // | gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  // | gl.DepthMask(GL_FALSE);
  // <<< student
}

std::optional<glm::ivec4> opening_rectangle(std::span<const glm::vec4> corners, const glm::ivec2& size,
                                            const glm::ivec4& around) {
  // >>> student: cut the polygon at the picture's sides, then find its bounds in pixels
  std::vector<glm::dvec4> visible(corners.begin(), corners.end());
  const glm::dvec4 sides[] = {{1, 0, 0, 1}, {-1, 0, 0, 1}, {0, 1, 0, 1}, {0, -1, 0, 1}};
  for (const glm::dvec4& side : sides) visible = part_inside(visible, side);
  glm::dvec2 low(1), high(-1);
  for (const glm::dvec4& p : visible) {
    if (p.w <= 0) continue;  // the eye itself
    low = glm::min(low, glm::dvec2(p) / p.w);
    high = glm::max(high, glm::dvec2(p) / p.w);
  }
  const glm::dvec2 half = 0.5 * glm::dvec2(size);
  const glm::ivec2 first = glm::max(glm::ivec2(glm::floor((low + 1.0) * half)), glm::ivec2(around.x, around.y));
  const glm::ivec2 last =
      glm::min(glm::ivec2(glm::ceil((high + 1.0) * half)), glm::ivec2(around.x + around.z, around.y + around.w));
  if (last.x <= first.x || last.y <= first.y) return {};
  return glm::ivec4(first, last - first);
  // --- skeleton
  // | return around;
  // <<< student
}

bool goes_through(const glm::dmat4& frame_to_world, const glm::dvec2& half_size, const glm::dvec3& from,
                  const glm::dvec3& to) {
  // >>> student: in the opening's frame: from which side to which, and where does the line meet the plane?
  const glm::dmat4 world_to_frame = inverse_of(frame_to_world);
  const glm::dvec3 a(world_to_frame * glm::dvec4(from, 1)), b(world_to_frame * glm::dvec4(to, 1));
  if (a.z < 0 || b.z >= 0) return false;
  const glm::dvec3 met = a + (b - a) * (a.z / (a.z - b.z));
  return std::abs(met.x) <= half_size.x && std::abs(met.y) <= half_size.y;
  // --- skeleton
  // | return false;
  // <<< student
}

Camera carried(const Camera& camera, const glm::dmat4& passage) {
  // >>> student: two points and a direction
  Camera after = camera;
  after.eye = glm::dvec3(passage * glm::dvec4(camera.eye, 1));
  after.target = glm::dvec3(passage * glm::dvec4(camera.target, 1));
  after.up = glm::vec3(glm::dmat3(passage) * glm::dvec3(camera.up));
  return after;
  // --- skeleton
  // | return camera;
  // <<< student
}

glm::vec4 plane_in_view(const glm::dvec4& plane_world, const glm::mat4& world_to_view) {
  // >>> student: planes are not points
  return glm::vec4(glm::transpose(glm::inverse(glm::dmat4(world_to_view))) * plane_world);
  // --- skeleton
  // | return glm::vec4(0, 0, 0, 1);
  // <<< student
}

glm::mat4 oblique_projection(const glm::mat4& projection, const glm::vec4& plane_view) {
  // >>> student: a new third row: the plane, scaled, minus the fourth row
  const glm::mat4 clip_to_view(glm::inverse(glm::dmat4(projection)));  // floats lose the far corner
  const glm::vec4 plane_clip = glm::transpose(clip_to_view) * plane_view;
  const glm::vec4 corner = clip_to_view * glm::vec4(plane_clip.x < 0 ? -1 : 1, plane_clip.y < 0 ? -1 : 1, 1, 1);
  const glm::mat4 rows = glm::transpose(projection);
  glm::mat4 oblique = rows;
  oblique[2] = 2 * glm::dot(rows[3], corner) / glm::dot(plane_view, corner) * plane_view - rows[3];
  return glm::transpose(oblique);
  // --- skeleton
  // | return projection;
  // <<< student
}

Light light_image(const Light& light, const glm::dmat4& passage) {
  // >>> student: a point and a direction
  Light image = light;
  image.position = glm::dvec3(passage * glm::dvec4(light.position, 1));
  image.direction = glm::vec3(glm::dmat3(passage) * glm::dvec3(light.direction));
  return image;
  // --- skeleton
  // | return light;
  // <<< student
}

bool stands_in(const glm::dmat4& frame_to_world, const glm::dvec2& half_size, std::span<const glm::dvec3, 8> corners) {
  // >>> student: in the opening's frame: on which sides of the plane, and of the rectangle, are the corners?
  const glm::dmat4 world_to_frame = inverse_of(frame_to_world);
  glm::dvec3 low(1e300), high(-1e300);
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 p(world_to_frame * glm::dvec4(corner, 1));
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return low.z < 0 && high.z > 0 && low.x <= half_size.x && high.x >= -half_size.x && low.y <= half_size.y &&
         high.y >= -half_size.y;
  // --- skeleton
  // | return false;
  // <<< student
}

}  // namespace atelier::stencil_portals
