// 03-shadow-mapping: the contract of shadow_mapping.cpp: the map, and the light's matrices. You also write
// depth_pass.glsl (how the map is drawn), shadow_mapping.glsl (how it is looked up) and some lines of choices.txt. The
// contract of each GLSL function is the comment above it in its file; types, uniforms and macros are in
// given/shadows.glsl.
//
// The idea (Williams, "Casting curved shadows on curved surfaces", 1978): a point is in shadow if the light does not
// see it. So the scene is first drawn from the light, and only depth is kept: the shadow map. Then, for every point
// that the camera sees, the map tells whether something else is nearer to the light on the same line.
//
//   world --light_view--> light space --light_projection--> clip space --divide by w--> -1..1 --bias_matrix--> 0..1
//
// The result is the shadow coordinate (u, v, z): u and v say where in the map, z is the depth to compare with the
// stored one.
//
// All lengths are metres, also those of biases. A bias is chosen in texels of the map and made metres by the width of a
// texel at the point. So one setting works in a scene of a millimetre and in one of a hundred kilometres, for spot
// lights and directional lights, with 16 bits of depth and with 32.
#pragma once

#include "02-blinn-phong/blinn_phong.hpp"

namespace atelier::shadow_mapping {

/// All points within `radius` metres of `centre`.
struct Sphere {
  glm::vec3 centre{0};
  float radius = 1;
};

/// What a light sees: a square pyramid in front of a spot light, a square box in front of a directional light. World
/// space.
struct LightFrustum {
  bool orthographic = false;      ///< a box: of a directional light
  glm::vec3 eye{0};               ///< depth is measured from here
  glm::vec3 direction{0, -1, 0};  ///< of unit length: where the light looks
  float extent = 1;               ///< half the angle of view in radians; orthographic: half the width in metres
  float near = 0.1f, far = 100;   ///< metres along the direction; above 0, but a box may have less
};

/// Depth maps of one size, one layer per light, and the framebuffer that draws into them. These are OpenGL names; the
/// caller deletes the objects.
struct ShadowMaps {
  GLuint texture = 0;  ///< a GL_TEXTURE_2D_ARRAY
  GLuint framebuffer = 0;
  int resolution = 0;  ///< texels along a side
  int layers = 0;
};

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: the map and the pass that draws it. Both functions leave no texture bound; any framebuffer may stay bound.
// `gl.Xyz(...)` is OpenGL's glXyz(...).
// ---------------------------------------------------------------------------------------------------------------------

/// Makes the texture: resolution x resolution texels, `layers` layers, `internal_format` (GL_DEPTH_COMPONENT16,
/// GL_DEPTH_COMPONENT24 or GL_DEPTH_COMPONENT32F). Outside of its edges it reads as 1, the farthest depth, by its
/// border (GL_CLAMP_TO_BORDER). Without `compare`, both filters are GL_NEAREST and the compare mode is GL_NONE; with it
/// they are GL_LINEAR and GL_COMPARE_REF_TO_TEXTURE. The compare function is GL_LEQUAL. The framebuffer has layer 0 as
/// its depth attachment and no colour (draw and read buffer are GL_NONE).
ShadowMaps make_shadow_maps(Gl& gl, int resolution, int layers, GLenum internal_format, bool compare);

/// Sets this state for drawing into layer `layer`, whatever it was before: framebuffer bound, with this layer as
/// its depth attachment; viewport: the whole map; depth test on, with GL_LESS and depth writes; depth clamping on
/// (GL_DEPTH_CLAMP: casters in front of the near plane are kept, with the depth of the plane); front faces culled if
/// cull_front_faces, otherwise no culling. Then clears the layer, and only it, to 1.
void begin_depth_pass(Gl& gl, const ShadowMaps& maps, int layer, bool cull_front_faces);

// ---------------------------------------------------------------------------------------------------------------------
// Core 2: what the light sees
// ---------------------------------------------------------------------------------------------------------------------

/// The pyramid of a spot light at `position` for a sphere. It looks at the centre, and its half-angle is that of the
/// narrowest cone around the sphere. But it looks along `direction` (any length but zero), with outer_angle as its
/// half-angle, where the light is inside the sphere or on it, or where outer_angle is less than the other half-angle.
/// In both cases the near and the far plane touch the sphere. Then: half-angle clamped to 0.001 to 1.5 radians, far at
/// least 1e-6, near at least far / 1000. Light 5 m from the centre, radius 3 m: 0.6435 radians, near 2 m, far 8 m.
/// Handout, section 3.
LightFrustum fit_spot(const glm::vec3& position, const glm::vec3& direction, float outer_angle, const Sphere& sphere);

/// World space to light space: the view matrix of a camera at `eye` that looks along `direction`, with +y up (straight
/// up or down: what look_at does there). The rotation must stay accurate where the eye is far from the world's origin,
/// to 1e9 m: the sum eye + direction is not. Handout, section 2. You may call: step 01's look_at, translation.
glm::mat4 light_view(const LightFrustum& frustum);

/// Light space to clip space: the square pyramid with the half-angle `extent`, or the square box with the half-width
/// `extent`, between near and far. A pyramid throws std::invalid_argument unless 0 < near < far, as step 01's function
/// does. You may call: step 01's perspective, orthographic.
glm::mat4 light_projection(const LightFrustum& frustum);

/// Takes -1..1 to 0..1 in x, y and z. It is applied before the division by w. Handout, section 2. You may call: step
/// 01's translation, scaling.
glm::mat4 bias_matrix();

// ---------------------------------------------------------------------------------------------------------------------
// Further: directional lights
// ---------------------------------------------------------------------------------------------------------------------

/// The smallest box of a directional light around a sphere. It looks along `direction` (any length but zero); its eye
/// is the centre of its near plane, so near is 0. A radius below 1e-6 counts as 1e-6. Radius 2 m: half-width 2 m, far
/// 4 m. Handout, section 3.
LightFrustum fit_directional(const glm::vec3& direction, const Sphere& sphere);

// ---------------------------------------------------------------------------------------------------------------------
// Challenge: shadows that do not crawl
// ---------------------------------------------------------------------------------------------------------------------

/// Makes edges of shadows stand still while the box that is fitted changes a little: its texels keep their size and
/// their places in the world. First the half-width is multiplied by 1 + 1/resolution (room for the shift below) and
/// rounded up to a power 2^(k/4), k an integer. Then the eye is shifted perpendicular to the direction: its distances
/// from the world's origin along the right and the up axis of light_view are rounded to integer multiples of a texel of
/// the new width, halves towards plus infinity. A pyramid is returned unchanged. Half-width 1 m,
/// 1024 texels: the new one is 1.1892 m. Handout, section 9. You may call: step 01's look_at.
LightFrustum snap_to_texels(const LightFrustum& frustum, int resolution);

}  // namespace atelier::shadow_mapping
