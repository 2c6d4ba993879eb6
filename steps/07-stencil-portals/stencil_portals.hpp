// 07-stencil-portals: the contract of stencil_portals.cpp: where a portal leads, how its view is marked, clipped and
// bounded, and how a visitor goes through it. You also write stencil_portals.glsl, where the contract of each function
// is the comment above it, and some lines of choices.txt.
//
// A portal is an opening, flat, in the plane z = 0 of its frame (a node of the scene). +z faces the side on which a
// visitor stands. Who enters it moves along its -z, and comes out of its exit, another frame, along the exit's +z. What
// is up stays up, and what is on the right stays on the right. A mirror is an opening without an exit.
//
// Frames only rotate and translate: a frame's matrix maps its own space to the world. All of this is in double
// precision, so that a visitor can go through portals ten thousand times, a million metres from the origin. Matrices of
// views and projections are those of step 01, in single precision.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "gl/gl.hpp"
#include "scene/scene.hpp"

namespace atelier::stencil_portals {

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: where a portal leads
// ---------------------------------------------------------------------------------------------------------------------

/// The passage of a portal: the matrix that maps a point of the world, a visitor before the entry for example, to where
/// it is after going through. Exact where both frames stand at quarter turns and at multiples of 1/1024 m, at most 4096
/// m from the origin. Handout, section 1.
/// Entry at the origin, exit at (10, 0, 0), both not turned: (1, 2, 3) is mapped to (9, 2, -3).
glm::dmat4 portal_passage(const glm::dmat4& entry_to_world, const glm::dmat4& exit_to_world);

/// The passage of a mirror: maps every point of the world to its image behind the mirror. Handout, section 1.
/// Mirror at the origin, not turned: (1, 2, 3) is mapped to (1, 2, -3).
glm::dmat4 mirror_passage(const glm::dmat4& mirror_to_world);

/// The view matrix of the virtual camera: of an eye that sees through the opening what the camera of `world_to_view`
/// sees in it. The passage is one of those above. Computed in double precision, then rounded. Handout, section 2.
glm::mat4 virtual_view(const glm::mat4& world_to_view, const glm::dmat4& passage);

/// The plane of an opening in the world, as (n, d): n.p + d is the distance of a point p from it in metres, positive on
/// the side that +z faces; or negative there, if `from_behind`. Handout, section 3.
/// Frame at (0, 0, 5), not turned: (0, 0, 1, -5), from behind (0, 0, -1, 5).
glm::dvec4 opening_plane(const glm::dmat4& frame_to_world, bool from_behind);

// ---------------------------------------------------------------------------------------------------------------------
// Core 2: marking. Before each of the two functions the caller sets all state to OpenGL's default, binds the
// framebuffer, bounds the view (scissor, clip distance), and enables the depth test with the view's depth function.
// After it, the caller draws the opening, and then sets all state anew.
// ---------------------------------------------------------------------------------------------------------------------

/// Sets the state for marking an opening: where it is visible and the stencil buffer holds `level` (0..254), the buffer
/// becomes level + 1. Neither colours nor depths change. Handout, section 4.
void begin_mark(Gl& gl, int level);

/// Sets the state for closing it again, after its view is drawn: where the stencil buffer holds level + 1, it becomes
/// `level`, and the depth becomes that of the opening, whatever it was. Colours do not change. Handout, section 4.
void begin_restore(Gl& gl, int level);

// ---------------------------------------------------------------------------------------------------------------------
// Core 3: only what is seen
// ---------------------------------------------------------------------------------------------------------------------

/// Where an opening is visible: the smallest rectangle of whole pixels (x, y of the lower left corner, width, height)
/// that holds the part of it inside of the picture. This rectangle is then cut to `around`, another one; none if no
/// pixel is left. `corners` are those of a convex polygon, in order, in clip space; those behind the eye have w < 0.
/// The picture has `size` pixels; x = -w and y = -w are its left and lower sides. Near and far planes do not matter. An
/// opening may be very near to the eye (a hundredth of a millimetre): floats are not enough. An edge that lies within
/// 0.001 pixel of a pixel's side may count as beyond it or not. An opening seen edge-on, and one with a corner at w = 0
/// exactly, may have any rectangle in `around`, or none. Handout, section 5.
///
/// Size 100 x 100, around all of it, corners (-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5) with w = 1:
/// (25, 25, 50, 50).
std::optional<glm::ivec4> opening_rectangle(std::span<const glm::vec4> corners, const glm::ivec2& size,
                                            const glm::ivec4& around);

// ---------------------------------------------------------------------------------------------------------------------
// Core 4: a visitor
// ---------------------------------------------------------------------------------------------------------------------

/// Whether a visitor who moves in a straight line from `from` to `to` (world space) goes through an opening from its
/// front. The opening is the rectangle |x| <= half_size.x, |y| <= half_size.y of its frame; its rim belongs to it, up
/// to rounding. Whoever starts on the plane or before it and ends behind it has gone through it, if the line meets the
/// rectangle; whoever ends on the plane has not. Handout, section 6.
bool goes_through(const glm::dmat4& frame_to_world, const glm::dvec2& half_size, const glm::dvec3& from,
                  const glm::dvec3& to);

/// A camera after it has gone through a portal: eye, target and up are carried through, up with its length; all else
/// stays. Handout, section 6.
Camera carried(const Camera& camera, const glm::dmat4& passage);

// ---------------------------------------------------------------------------------------------------------------------
// Further: clipping with the near plane
// ---------------------------------------------------------------------------------------------------------------------

/// (further) A plane of the world in view space: for every point p of the world, with v = world_to_view p, both say the
/// same distance. The view only rotates, translates and reflects. Computed in double precision, then rounded. Handout,
/// section 7.
glm::vec4 plane_in_view(const glm::dvec4& plane_world, const glm::mat4& world_to_view);

/// (further) The projection with its near plane moved onto a plane of view space, so that OpenGL clips what is on the
/// plane's negative side (Lengyel 2005): x, y and w of every point stay as they are; z = -w on the plane; and of the
/// corners of the view volume on its far plane, the one that is farthest from the plane keeps z = w. `projection` is a
/// perspective one of step 01 (depths from -w to w). The eye is on the plane's negative side, so plane.w < 0, and that
/// far corner on its positive side. Handout, section 7.
glm::mat4 oblique_projection(const glm::mat4& projection, const glm::vec4& plane_view);

// ---------------------------------------------------------------------------------------------------------------------
// Challenge: light and bodies that go through. You also write `comes_out` in stencil_portals.glsl.
// ---------------------------------------------------------------------------------------------------------------------

/// (challenge) The image of a light: the light that lights every point behind the exit as the light itself does through
/// the portal (or after the mirror). Its place and the direction in which it shines are carried through; all else
/// stays. What a type does not use (a point light's direction, a directional light's place) may become anything.
/// Handout, section 8.
Light light_image(const Light& light, const glm::dmat4& passage);

/// (challenge) Whether a body stands in an opening, so that one part of it is before the plane and another has gone
/// through. `corners` are those of the body's box in the world, in any order; the box may stand askew. True where the
/// plane parts the box and their common polygon meets the opening's rectangle (|x| <= half_size.x, |y| <= half_size.y
/// of the frame). False where all corners are on one side of the plane, or all beyond one side of the rectangle (x >
/// half_size.x, say). In between, either answer is right. Within 1e-6 m of these limits either answer is right, too.
/// Handout, section 8.
bool stands_in(const glm::dmat4& frame_to_world, const glm::dvec2& half_size, std::span<const glm::dvec3, 8> corners);

}  // namespace atelier::stencil_portals
