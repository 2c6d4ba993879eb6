// 12-gallery: the contract of gallery.cpp: a round hall whose paintings are doors, a visitor who walks through them,
// and pictures of the rooms behind them that are drawn again only when they must be. You also write lines of
// choices.txt.
//
// World space: metres, +y up, floors at y = 0. All frames stand upright. A painting is the rectangle |x| <=
// half_size.x, |y| <= half_size.y in the plane z = 0 of its frame; +z faces the side from which it is seen. Each
// painting leads to an exit, another such frame, as the portals of step 07 do: who goes in along -z of the one comes
// out along +z of the other.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "gl/gl.hpp"
#include "scene/scene.hpp"

namespace atelier::gallery {

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: the hall
// ---------------------------------------------------------------------------------------------------------------------

/// The wall of a round hall, seen from inside: `segments` (3 or more) flat sides of equal width, whose corners stand on
/// the circle of this radius around the y axis, from y = 0 to y = height. One corner stands at +z, where the wall ends
/// without a gap. Front faces are counter-clockwise from inside; normals are of unit length, and those of the circle.
/// The texture runs `repeat` times around, u from 0 at +z to `repeat` at +z again, so that it is not mirrored from
/// inside; v is 0 at the floor and 1 at the top. Any triangles will do whose vertices stand at the corners of the
/// circle. Handout, section 1.
///
/// Four segments, radius 2: corners at (0, y, 2), (-2, y, 0), (0, y, -2), (2, y, 0), in the order of u.
Mesh hall_wall(int segments, float radius, float height, float repeat);

/// The frame of painting `index` of `count`: its centre is `distance` away from the y axis, at this height; its +z
/// points to the axis, its +y up. The paintings hang at equal angles; painting 0 at -z, the next ones follow
/// counter-clockwise seen from above. Handout, section 1.
/// Index 1 of 4, distance 5, height 2: the centre is (-5, 2, 0), and +z of the frame is +x of the world.
glm::dmat4 painting_frame(int index, int count, double distance, double height);

// ---------------------------------------------------------------------------------------------------------------------
// Core 2: a visitor, who is a box that moves and does not turn
// ---------------------------------------------------------------------------------------------------------------------

constexpr int hall = -1;

struct Visitor {
  glm::dvec3 position{0};  ///< of the box's centre, in the world
  glm::dvec3 velocity{0};  ///< m/s
  int room = hall;         ///< the hall, or the room behind painting 0, 1, ...
};

inline constexpr glm::dvec3 visitor_half_size{0.25, 0.875, 0.25};  // metres

/// The eight corners of a visitor's box, in no particular order.
inline std::array<glm::dvec3, 8> corners_of(const glm::dvec3& position) {
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i)
    corners[i] = position + visitor_half_size * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  return corners;
}

/// Whether a plane meets a box: not all corners are on one side of it. `plane` is (n, d), of any length: n.p + d is
/// positive on one side of it. A corner on the plane is on both sides. Handout, section 2.
bool meets(const glm::dvec4& plane, std::span<const glm::dvec3, 8> corners);

/// The two planes through the left and the right side of a painting, square to it: (n, d) with |n| = 1, and n.p + d the
/// distance in metres, positive on the side where the painting is. Their order is free. Handout, section 2.
std::array<glm::dvec4, 2> side_planes(const glm::dmat4& frame, const glm::dvec2& half_size);

/// Whether a visitor touches a painting from its front: the box's heights and the painting's have one in common; the
/// painting's plane meets the box; the visitor's position is not outside of either side plane, and not behind the
/// painting. Limits belong to all of these, up to rounding. Handout, section 2.
bool touches(const glm::dmat4& frame, const glm::dvec2& half_size, const glm::dvec3& position);

/// A visitor who has gone through a painting into `room`. The position is where portal_passage of step 07 takes it;
/// from there it moves along the exit's +z, as little as needed, until all corners of the box are `clearance` before
/// the exit's plane or more. The velocity is a jump: `speed` along the exit's +z, plus `speed` upwards. Handout,
/// section 3.
Visitor gone_through(const Visitor& visitor, const glm::dmat4& entry, const glm::dmat4& exit, int room,
                     double clearance, double speed);

inline constexpr double gravity = 9.81;  // m/s^2, downwards

/// A visitor after `seconds`, from 0 up to an hour and more. In the air (the box's lower side is above y = 0, or its
/// velocity points up) it flies: gravity changes the velocity, and nothing else does. It lands where its lower side
/// reaches y = 0; from then on it walks with the horizontal velocity `walking` (x and z, m/s), and the velocity's y is
/// 0. Exact: two steps of half the time lead to the same place as one, up to rounding, also if it lands on the way.
/// Handout, section 3.
Visitor moved(const Visitor& visitor, const glm::dvec2& walking, double seconds);

/// Where the walls of a place hold a visitor: a position at which no corner of the box is behind a wall by more than
/// 1e-9 m. `walls` are the planes of a convex place, (n, d) with |n| = 1, positive inside; there is room for the box.
/// Where no wall is in the way, the position stays. Where one is and the others stay free, it moves along that wall's
/// normal, as little as needed: one slides along a wall. In corners any position will do that is at most four times as
/// far away as the nearest. Handout, section 3.
glm::dvec3 held(std::span<const glm::dvec4> walls, const glm::dvec3& position);

// ---------------------------------------------------------------------------------------------------------------------
// Core 3: previews
// ---------------------------------------------------------------------------------------------------------------------

/// The camera that records the picture of a room for its painting: what an eye sees that stands `distance` before the
/// middle of the painting and looks straight at it, if the painting were a portal. The picture shows exactly what is
/// seen through the rectangle of half_size, so the near plane is the exit's plane. `far` is from the eye. Handout,
/// section 4.
Camera preview_camera(const glm::dmat4& exit, const glm::dvec2& half_size, double distance, float far);

/// The maps of a painting: what is seen, its normals, its heights.
enum class Map { colour, normal, height };

/// OpenGL names of the maps, by Map, and of the framebuffer that draws into them. All are square.
struct Preview {
  std::array<GLuint, 3> textures{};
  GLuint framebuffer = 0;
};

/// Creates the maps of a painting, with `size` pixels a side: textures of format GL_RGBA16F with all their mipmaps,
/// filtered linearly between texels and between mipmaps, clamped to the edge. The framebuffer has the colour map as its
/// first colour attachment, and no other attachment. Leaves no texture and no framebuffer bound, and other state as it
/// is. Handout, section 4.
Preview make_preview(Gl& gl, int size);

/// Copies a picture into a map of a preview, whose size it has, and makes the map's mipmaps. `picture` is a framebuffer
/// whose first colour attachment holds it. Other maps stay as they are. Leaves no texture and no framebuffer bound; no
/// other state matters or changes. Handout, section 4.
void record(Gl& gl, const Preview& preview, Map map, GLuint picture);

/// What is known of a preview.
struct PreviewState {
  bool visible = false;            ///< whether the painting is in view
  std::uint64_t version = 0;       ///< of the room: whenever it looks different, it has another one
  bool recorded = false;           ///< whether it was ever recorded
  std::uint64_t recorded_of = 0;   ///< then, which version it shows
  std::uint64_t frames_since = 0;  ///< then, how many frames ago
};

/// The previews that are recorded in this frame, by index, in the order in which they are: those in view that were
/// never recorded or show another version, at most `most` of them (0 or more). Those that were never recorded come
/// first, then those that have waited longest; of equals the one with the lower index. Handout, section 5.
std::vector<int> previews_to_record(std::span<const PreviewState> previews, int most);

// ---------------------------------------------------------------------------------------------------------------------
// Core 4: styles
// ---------------------------------------------------------------------------------------------------------------------

enum class Style { none, floyd_steinberg, painterly, fisheye, toon, aberration };

/// The style of what is seen from a place: of room 0, 1, ... 5, in the order of Style; of the hall, and of every other
/// number, none. Handout, section 6.
Style style_of(int room);

}  // namespace atelier::gallery
