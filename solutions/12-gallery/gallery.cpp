#include "12-gallery/gallery.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "07-stencil-portals/stencil_portals.hpp"

namespace atelier::gallery {

// >>> student: what your functions below share, if anything
namespace {

/// The signed distance of a point from a plane with a normal of unit length.
double distance(const glm::dvec4& plane, const glm::dvec3& point) {
  return glm::dot(plane, glm::dvec4(point, 1));
}

/// The plane through a point with this normal.
glm::dvec4 plane_through(const glm::dvec3& point, const glm::dvec3& normal) {
  return {normal, -glm::dot(normal, point)};
}

/// How far the box reaches from its centre along a direction.
double reach(const glm::dvec3& direction) {
  return glm::dot(glm::abs(direction), visitor_half_size);
}

}  // namespace
// --- skeleton
// <<< student

Mesh hall_wall(int segments, float radius, float height, float repeat) {
  // >>> student: corners on a circle; which way round, and how many at the seam?
  Mesh mesh;
  mesh.name = "wall";
  for (int i = 0; i <= segments; ++i) {
    // The last corner is the first one again, with another texture coordinate.
    const double turn = 2 * std::numbers::pi * (i % segments) / segments;
    const glm::vec3 outwards(-std::sin(turn), 0, std::cos(turn));
    const float u = repeat * float(i) / float(segments);
    mesh.vertices.push_back({radius * outwards, -outwards, {u, 0}});
    mesh.vertices.push_back({radius * outwards + glm::vec3(0, height, 0), -outwards, {u, 1}});
  }
  for (std::uint32_t i = 0; i < std::uint32_t(segments); ++i) {
    const std::uint32_t low = 2 * i, top = low + 1, next_low = low + 2, next_top = low + 3;
    mesh.indices.insert(mesh.indices.end(), {low, next_low, next_top, low, next_top, top});
  }
  return mesh;
  // --- skeleton
  // | static_cast<void>(segments), static_cast<void>(radius), static_cast<void>(height), static_cast<void>(repeat);
  // | return {};
  // <<< student
}

glm::dmat4 painting_frame(int index, int count, double distance, double height) {
  // >>> student: where are its axes?
  const double turn = 2 * std::numbers::pi * index / count;
  const glm::dvec3 inwards(std::sin(turn), 0, std::cos(turn)), up(0, 1, 0);
  return {glm::dvec4(glm::cross(up, inwards), 0), glm::dvec4(up, 0), glm::dvec4(inwards, 0),
          glm::dvec4(-distance * inwards + height * up, 1)};
  // --- skeleton
  // | static_cast<void>(index), static_cast<void>(count), static_cast<void>(distance), static_cast<void>(height);
  // | return glm::dmat4(1);
  // <<< student
}

bool meets(const glm::dvec4& plane, std::span<const glm::dvec3, 8> corners) {
  // >>> student: on which sides are the corners?
  const auto side = [&](const glm::dvec3& corner) { return glm::dot(plane, glm::dvec4(corner, 1)); };
  return std::ranges::any_of(corners, [&](const glm::dvec3& corner) { return side(corner) >= 0; }) &&
         std::ranges::any_of(corners, [&](const glm::dvec3& corner) { return side(corner) <= 0; });
  // --- skeleton
  // | static_cast<void>(plane), static_cast<void>(corners);
  // | return false;
  // <<< student
}

std::array<glm::dvec4, 2> side_planes(const glm::dmat4& frame, const glm::dvec2& half_size) {
  // >>> student: which direction do both look in?
  const glm::dvec3 right(frame[0]), centre(frame[3]);
  return {plane_through(centre - half_size.x * right, right), plane_through(centre + half_size.x * right, -right)};
  // --- skeleton
  // | static_cast<void>(frame), static_cast<void>(half_size);
  // | return {};
  // <<< student
}

bool touches(const glm::dmat4& frame, const glm::dvec2& half_size, const glm::dvec3& position) {
  // >>> student: what is cheap to rule out comes first
  if (std::abs(position.y - frame[3].y) > half_size.y + visitor_half_size.y) return false;
  const glm::dvec4 plane = plane_through(glm::dvec3(frame[3]), glm::dvec3(frame[2]));
  if (distance(plane, position) < 0 || !meets(plane, corners_of(position))) return false;
  return std::ranges::all_of(side_planes(frame, half_size),
                             [&](const glm::dvec4& side) { return distance(side, position) >= 0; });
  // --- skeleton
  // | static_cast<void>(frame), static_cast<void>(half_size), static_cast<void>(position);
  // | return false;
  // <<< student
}

Visitor gone_through(const Visitor& visitor, const glm::dmat4& entry, const glm::dmat4& exit, int room,
                     double clearance, double speed) {
  // >>> student: where is the box now, and what is still behind the plane?
  const glm::dmat4 passage = stencil_portals::portal_passage(entry, exit);
  const glm::dvec3 ahead(exit[2]);
  glm::dvec3 position(passage * glm::dvec4(visitor.position, 1));
  const double before = distance(plane_through(glm::dvec3(exit[3]), ahead), position) - reach(ahead);
  position += std::max(clearance - before, 0.0) * ahead;
  return {.position = position, .velocity = speed * (ahead + glm::dvec3(0, 1, 0)), .room = room};
  // --- skeleton
  // | static_cast<void>(entry), static_cast<void>(exit), static_cast<void>(clearance), static_cast<void>(speed);
  // | Visitor after = visitor;
  // | after.room = room;
  // | return after;
  // <<< student
}

Visitor moved(const Visitor& visitor, const glm::dvec2& walking, double seconds) {
  // >>> student: when does it land, and what remains of the time?
  Visitor after = visitor;
  const double above = visitor.position.y - visitor_half_size.y, up = visitor.velocity.y;
  const bool flies = above > 0 || up > 0;
  // The later root of above + up t - g t^2 / 2 = 0.
  const double landing = flies ? (up + std::sqrt(up * up + 2 * gravity * above)) / gravity : 0;
  const double flight = std::min(seconds, landing);
  if (flies) {
    after.position += visitor.velocity * flight;
    after.position.y -= gravity * flight * flight / 2;
    after.velocity.y -= gravity * flight;
  }
  if (seconds < landing) return after;
  after.velocity = {walking.x, 0, walking.y};
  after.position.y = visitor_half_size.y;
  after.position += after.velocity * (seconds - flight);
  return after;
  // --- skeleton
  // | static_cast<void>(walking), static_cast<void>(seconds);
  // | return visitor;
  // <<< student
}

glm::dvec3 held(std::span<const glm::dvec4> walls, const glm::dvec3& position) {
  // >>> student: how far is the farthest corner behind a wall? And after another wall has pushed?
  glm::dvec3 at = position;
  // Each push may lead behind another wall; the errors shrink by a constant factor in each round.
  for (int round = 0; round < 10000; ++round) {
    double worst = 0;
    for (const glm::dvec4& wall : walls) {
      const glm::dvec3 inwards(wall);
      const double behind = reach(inwards) - distance(wall, at);
      if (behind > 0) at += behind * inwards;
      worst = std::max(worst, behind);
    }
    if (worst <= 1e-10) break;
  }
  return at;
  // --- skeleton
  // | static_cast<void>(walls);
  // | return position;
  // <<< student
}

Camera preview_camera(const glm::dmat4& exit, const glm::dvec2& half_size, double distance, float far) {
  // >>> student: where does the eye stand, seen from the exit?
  const glm::dvec3 centre(exit[3]), ahead(exit[2]);
  return {.eye = centre - distance * ahead,
          .target = centre,
          .up = glm::vec3(exit[1]),
          .fov_y = float(2 * std::atan(half_size.y / distance)),
          .near = float(distance),
          .far = far};
  // --- skeleton
  // | static_cast<void>(exit), static_cast<void>(half_size), static_cast<void>(distance), static_cast<void>(far);
  // | return {};
  // <<< student
}

Preview make_preview(Gl& gl, int size) {
  // >>> student: three textures, one framebuffer
  Preview preview;
  gl.GenTextures(GLsizei(preview.textures.size()), preview.textures.data());
  for (const GLuint texture : preview.textures) {
    gl.BindTexture(GL_TEXTURE_2D, texture);
    for (int level = 0, side = size;; ++level, side /= 2) {
      gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA16F, side, side, 0, GL_RGBA, GL_FLOAT, nullptr);
      if (side == 1) break;
    }
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.GenFramebuffers(1, &preview.framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, preview.framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, preview.textures[0], 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  return preview;
  // --- skeleton
  // | static_cast<void>(gl), static_cast<void>(size);
  // | return {};
  // <<< student
}

void record(Gl& gl, const Preview& preview, Map map, GLuint picture) {
  // >>> student: what is read, what is written, and how large is it?
  const GLuint texture = preview.textures[std::size_t(map)];
  GLint size = 0;
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &size);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, picture);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, preview.framebuffer);
  gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  const GLboolean scissor = gl.IsEnabled(GL_SCISSOR_TEST);
  gl.Disable(GL_SCISSOR_TEST);  // it would cut the copy
  gl.BlitFramebuffer(0, 0, size, size, 0, 0, size, size, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  if (scissor) gl.Enable(GL_SCISSOR_TEST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.GenerateMipmap(GL_TEXTURE_2D);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  // --- skeleton
  // | static_cast<void>(gl), static_cast<void>(preview), static_cast<void>(map), static_cast<void>(picture);
  // <<< student
}

std::vector<int> previews_to_record(std::span<const PreviewState> previews, int most) {
  // >>> student: which need it, and who comes first?
  std::vector<int> wanted;
  for (std::size_t i = 0; i < previews.size(); ++i) {
    const PreviewState& preview = previews[i];
    if (preview.visible && !(preview.recorded && preview.recorded_of == preview.version)) wanted.push_back(int(i));
  }
  const auto before = [&](int a, int b) {
    const PreviewState &first = previews[std::size_t(a)], &second = previews[std::size_t(b)];
    if (first.recorded != second.recorded) return second.recorded;
    return first.recorded && first.frames_since > second.frames_since;
  };
  std::ranges::stable_sort(wanted, before);
  if (int(wanted.size()) > most) wanted.resize(std::size_t(most));
  return wanted;
  // --- skeleton
  // | static_cast<void>(previews), static_cast<void>(most);
  // | return {};
  // <<< student
}

Style style_of(int room) {
  // >>> student: and the hall's?
  return room >= 0 && room <= int(Style::aberration) ? Style(room) : Style::none;
  // --- skeleton
  // | static_cast<void>(room);
  // | return Style::none;
  // <<< student
}

}  // namespace atelier::gallery
