#include "12-gallery/gallery.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "07-stencil-portals/stencil_portals.hpp"

namespace atelier::gallery {

// TODO(12-gallery): what your functions below share, if anything

Mesh hall_wall(int segments, float radius, float height, float repeat) {
  // TODO(12-gallery): corners on a circle; which way round, and how many at the seam?
  static_cast<void>(segments), static_cast<void>(radius), static_cast<void>(height), static_cast<void>(repeat);
  return {};
}

glm::dmat4 painting_frame(int index, int count, double distance, double height) {
  // TODO(12-gallery): where are its axes?
  static_cast<void>(index), static_cast<void>(count), static_cast<void>(distance), static_cast<void>(height);
  return glm::dmat4(1);
}

bool meets(const glm::dvec4& plane, std::span<const glm::dvec3, 8> corners) {
  // TODO(12-gallery): on which sides are the corners?
  static_cast<void>(plane), static_cast<void>(corners);
  return false;
}

std::array<glm::dvec4, 2> side_planes(const glm::dmat4& frame, const glm::dvec2& half_size) {
  // TODO(12-gallery): which direction do both look in?
  static_cast<void>(frame), static_cast<void>(half_size);
  return {};
}

bool touches(const glm::dmat4& frame, const glm::dvec2& half_size, const glm::dvec3& position) {
  // TODO(12-gallery): what is cheap to rule out comes first
  static_cast<void>(frame), static_cast<void>(half_size), static_cast<void>(position);
  return false;
}

Visitor gone_through(const Visitor& visitor, const glm::dmat4& entry, const glm::dmat4& exit, int room,
                     double clearance, double speed) {
  // TODO(12-gallery): where is the box now, and what is still behind the plane?
  static_cast<void>(entry), static_cast<void>(exit), static_cast<void>(clearance), static_cast<void>(speed);
  Visitor after = visitor;
  after.room = room;
  return after;
}

Visitor moved(const Visitor& visitor, const glm::dvec2& walking, double seconds) {
  // TODO(12-gallery): when does it land, and what remains of the time?
  static_cast<void>(walking), static_cast<void>(seconds);
  return visitor;
}

glm::dvec3 held(std::span<const glm::dvec4> walls, const glm::dvec3& position) {
  // TODO(12-gallery): how far is the farthest corner behind a wall? And after another wall has pushed?
  static_cast<void>(walls);
  return position;
}

Camera preview_camera(const glm::dmat4& exit, const glm::dvec2& half_size, double distance, float far) {
  // TODO(12-gallery): where does the eye stand, seen from the exit?
  static_cast<void>(exit), static_cast<void>(half_size), static_cast<void>(distance), static_cast<void>(far);
  return {};
}

Preview make_preview(Gl& gl, int size) {
  // TODO(12-gallery): three textures, one framebuffer
  static_cast<void>(gl), static_cast<void>(size);
  return {};
}

void record(Gl& gl, const Preview& preview, Map map, GLuint picture) {
  // TODO(12-gallery): what is read, what is written, and how large is it?
  static_cast<void>(gl), static_cast<void>(preview), static_cast<void>(map), static_cast<void>(picture);
}

std::vector<int> previews_to_record(std::span<const PreviewState> previews, int most) {
  // TODO(12-gallery): which need it, and who comes first?
  static_cast<void>(previews), static_cast<void>(most);
  return {};
}

Style style_of(int room) {
  // TODO(12-gallery): and the hall's?
  static_cast<void>(room);
  return Style::none;
}

}  // namespace atelier::gallery
