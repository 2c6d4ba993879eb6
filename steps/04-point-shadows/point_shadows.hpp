// 04-point-shadows: the contract of point_shadows.cpp: the cube map and its six views. You also write cube_pass.glsl
// (how the cube is drawn) and point_shadows.glsl (how it is looked up). The contract of each GLSL function is the
// comment above it in its file; types and uniforms are in given/cubes.glsl.
//
// A point light shines in all directions, so it needs a map of all directions: six square maps of 90 degrees each, the
// faces of a cube around it. OpenGL looks a cube map up by a direction. So not a depth along an axis is stored and
// compared, but the distance from the light as a fraction of the farthest distance: |p - L| / far.
//
// The order of the faces is OpenGL's (specification 3.3, section 3.8.10): 0 is +x, 1 -x, 2 +y, 3 -y, 4 +z, 5 -z.
//
// Soft shadows (shadow.soft = pcss, light.width) exist for step 03's maps only: the penumbra of a cube is as wide as
// its filter. At most four point lights have a cube, the first ones that need it; others cast no shadow.
#pragma once

#include <optional>
#include <span>
#include <stdexcept>

#include "03-shadow-mapping/shadow_mapping.hpp"

namespace atelier::point_shadows {

using shadow_mapping::Sphere;

/// A cube of depth maps and the framebuffer that draws into it. These are OpenGL names; the caller deletes the objects.
struct CubeMap {
  GLuint texture = 0;  ///< a GL_TEXTURE_CUBE_MAP
  GLuint framebuffer = 0;
  int resolution = 0;  ///< texels along an edge
};

/// A cone whose apex is a light.
struct Cone {
  glm::vec3 axis{0, -1, 0};  ///< of unit length
  float half_angle = 0;      ///< radians
};

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: the cube and the pass that draws it. Both functions leave no texture bound.
// ---------------------------------------------------------------------------------------------------------------------

/// Makes six faces of resolution x resolution texels of `internal_format` (GL_DEPTH_COMPONENT16, 24 or 32F). All three
/// wrap modes are GL_CLAMP_TO_EDGE. Filters, compare mode and compare function are as in step 03's make_shadow_maps.
/// Enables GL_TEXTURE_CUBE_MAP_SEAMLESS, so that filters also read texels of the neighbouring face. The framebuffer has
/// the whole cube as a layered depth attachment (glFramebufferTexture) and no colour (draw and read buffer are
/// GL_NONE).
CubeMap make_cube_map(Gl& gl, int resolution, GLenum internal_format, bool compare);

/// Sets all state for drawing, whatever the state was before: framebuffer bound, with face 0 to 5 alone as its depth
/// attachment (glFramebufferTexture2D), or for -1 with the whole cube (layered: a geometry shader chooses the face);
/// viewport: a whole face; depth test on, with GL_LESS and depth writes; depth clamping on; front faces culled if
/// cull_front_faces, otherwise no culling. Then clears what is attached, and only that, to 1.
void begin_cube_pass(Gl& gl, const CubeMap& cube, int face, bool cull_front_faces);

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: the six views
// ---------------------------------------------------------------------------------------------------------------------

/// World space to the view space of a face, 0 to 5, of the cube around `position`: what is drawn with it lies where
/// OpenGL looks it up. So the view looks along the face's axis, and its right and up are the directions in which
/// OpenGL's s and t grow: handout, section 2, has the table. Face 0 looks along +x, with right -z and up -y. Throws
/// std::invalid_argument for any other face. You may call: step 01's look_at.
glm::mat4 face_view(const glm::vec3& position, int face);

/// The perspective projection of a face, square and 90 degrees wide: six faces leave no gap and no overlap. Throws
/// std::invalid_argument unless 0 < near < far. You may call: step 01's perspective.
glm::mat4 face_projection(float near, float far);

// ---------------------------------------------------------------------------------------------------------------------
// Further: point lights that need no cube
// ---------------------------------------------------------------------------------------------------------------------

/// A cone with its apex at `position` that holds all spheres. Its axis is the direction of the sum of the unit vectors
/// to their centres. Its half-angle is the smallest with which no sphere sticks out; small angles keep their accuracy.
/// None where there are no spheres, where the position is inside or on a sphere (distance <= radius), where the sum is
/// shorter than 1e-4, where squares of the lengths are out of the range of floats, or where the half-angle is above
/// `widest` (radians). One sphere of radius 1 m, 2 m away: pi/6. Handout, section 7.
std::optional<Cone> cone_around(const glm::vec3& position, std::span<const Sphere> spheres, float widest);

}  // namespace atelier::point_shadows
