// 04-point-shadows: the contract. You write point_shadows.cpp (the cube map and its six views), cube_pass.glsl (how it
// is drawn) and point_shadows.glsl (how it is looked up). The GLSL functions are declared in this file as comments;
// their types and uniforms are in cubes.glsl. (cube_pass.glsl sees in vec3 v_corner_world[], out vec3 g_position_world,
// uniform mat4 u_face_matrices[6] and uniform float u_face_wanted[6] in the geometry shader, nothing else.)
//
// A lamp that shines all round needs a map all round: six square maps of 90 degrees each, the faces of a cube around
// it. OpenGL looks a cube map up by a direction, so what is stored and what is compared is not a depth along some axis
// but the distance from the lamp, as a share of the farthest distance: |p - L| / far. (Depths along the axes and
// distances differ by up to sqrt(3), at the corners: compare like with like.)
//
// Half-shadows (shadow.soft = pcss, light.width) are a matter of step 03's maps; a cube's edges are as soft as its
// filter. At most four lamps have a cube, the first that need one; the others cast no shadow.
//
// The cube's convention is OpenGL's (specification 3.3, section 3.8.10): faces +x, -x, +y, -y, +z, -z in this order;
// seen from the middle of the cube the pictures stand on their heads, which is why a face's view has -y up, and those
// of +y and -y have +z and -z.
//
// In cube_pass.glsl (Core 1):
//
//   void draw_in_faces()                                                             (geometry shader)
//       Emits the triangle whose corners are v_corner_world[0..2] once for every face whose u_face_wanted[face] is
//       above 0.5: gl_Layer says into which face, gl_Position is u_face_matrices[face] * corner, and g_position_world
//       carries the corner on to the fragment shader. All three are set anew for every vertex: EmitVertex() forgets
//       them. Ends each triangle with EndPrimitive().
//   float stored_distance(vec3 position, vec3 light, float far)                      (fragment shader)
//       What the map holds: |position - light| / far, at most 1.
//
// In point_shadows.glsl (fragment shader; Core 2):
//
//   float cube_texel(vec3 from_light, float resolution)
//       How many metres wide a texel of the cube is where the lamp's light arrives at `from_light` (the way from the
//       lamp, metres): the face is as far away as the largest of |x|, |y|, |z|, and twice as wide as far.
//   float cube_lit(int cube, vec3 from_light, float reference)
//       One comparison: 1 where the reference (a distance / far) is at most what the cube holds in this direction,
//       otherwise 0; 1 where the direction is zero. stored_in_cube(cube, direction) reads the stored value; with
//       COMPARE defined compared_with_cube(cube, direction, reference) compares four texels and mixes the answers.
//   float cube_pcf(CubeLight light, vec3 from_light, float reference)
//       The mean of PCF x PCF comparisons, all with this reference, in a square grid of directions around from_light:
//       steps of one texel (cube_texel) along u = normalize(cross(a, from_light)) and v = cross(normalize(from_light),
//       u), middle at from_light; a is the first of the axes x, y, z with the smallest |component| of from_light. 1
//       where from_light is zero.
//   float point_shadow_factor(CubeLight light, vec3 position, vec3 normal, vec3 to_light)
//       The share of the lamp's light that reaches a point, 1 or 0 and between. First the bias by the define BIAS, as
//       in step 03, with amount = u_bias * KERNEL * cube_texel of the unmoved point: 1 constant_bias, 2 slope_bias, 3
//       and 4 normal_offset. Because distances are stored, not depths, alpha is the angle to to_light: that is the axis
//       to hand over. Then the distance of the moved point from the lamp over light.far, at most 1 (what lies beyond
//       the farthest caster is compared as if it lay there), less u_depth_step where BIAS is not 0, is looked up in the
//       moved point's direction.
#pragma once

#include <optional>
#include <span>
#include <stdexcept>

#include "03-shadow-mapping/shadow_mapping.hpp"

namespace atelier::point_shadows {

using shadow_mapping::Sphere;

/// A cube of depth maps and the framebuffer through which it is drawn. Names of objects that the receiver deletes.
struct CubeMap {
  GLuint texture = 0;  ///< a GL_TEXTURE_CUBE_MAP
  GLuint framebuffer = 0;
  int resolution = 0;  ///< texels along an edge
};

/// A cone with its apex at a lamp.
struct Cone {
  glm::vec3 axis{0, -1, 0};  ///< of unit length
  float half_angle = 0;      ///< radians
};

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: the cube and the pass that draws it. Both leave no texture bound.
// ---------------------------------------------------------------------------------------------------------------------

/// Makes six faces of resolution x resolution texels of `internal_format` (GL_DEPTH_COMPONENT16, 24 or 32F), clamped to
/// their edges in all three directions, and a framebuffer that has the whole cube as a layered depth attachment
/// (glFramebufferTexture) and no colour. Filters and compare mode as in step 03: GL_NEAREST and GL_NONE, or, with
/// `compare`, GL_LINEAR, GL_COMPARE_REF_TO_TEXTURE and GL_LEQUAL. Switches GL_TEXTURE_CUBE_MAP_SEAMLESS on, so that
/// filters reach across the edges.
CubeMap make_cube_map(Gl& gl, int resolution, GLenum internal_format, bool compare);

/// Makes everything ready for drawing: framebuffer bound; `face` 0..5 attaches that face alone
/// (glFramebufferTexture2D), `face` -1 the whole cube (layered, for a geometry shader that chooses); viewport all of a
/// face, depth test on (GL_LESS, writing), depth clamping on; what is attached cleared to 1. Culls front faces where
/// asked, otherwise nothing.
void begin_cube_pass(Gl& gl, const CubeMap& cube, int face, bool cull_front_faces);

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: the six views
// ---------------------------------------------------------------------------------------------------------------------

/// World space to the space of face 0..5 of a cube around `position`: step 01's look_at along +x, -x, +y, -y, +z, -z
/// with the up vectors -y, -y, +z, -z, -y, -y. Throws std::invalid_argument for another face.
glm::mat4 face_view(const glm::vec3& position, int face);

/// 90 degrees, square: step 01's perspective. Six of them leave no gap and no overlap.
glm::mat4 face_projection(float near, float far);

// ---------------------------------------------------------------------------------------------------------------------
// Further: lamps that need no cube
// ---------------------------------------------------------------------------------------------------------------------

/// A cone around all spheres, as seen from `position`: its axis is the direction of the sum of the unit vectors to
/// their centres, its half-angle the largest angle from the axis to a sphere's farthest edge (to the centre, plus
/// asin(radius / distance)). None where there are no spheres, where the position lies within one of them (distance <=
/// radius), where the sum is shorter than 1e-4, or where the half-angle is above `widest`: then only a cube will do.
std::optional<Cone> cone_around(const glm::vec3& position, std::span<const Sphere> spheres, float widest);

}  // namespace atelier::point_shadows
