// 03-shadow-mapping: the contract. You write shadow_mapping.cpp (the map and the light's matrices), depth_pass.glsl
// (how the map is drawn), shadow_mapping.glsl (how it is looked up) and some lines of choices.txt. The GLSL functions
// are declared in this file as comments; their types and uniforms are in shadows.glsl.
//
// The idea (Williams, "Casting curved shadows on curved surfaces", 1978): what a light does not see is in its shadow.
// So the scene is drawn once from the light, depth alone; afterwards every point that is drawn for the eye is asked
// whether something else is nearer to the light along the same line.
//
//   world --light_view--> the light's space --light_projection--> clip --divide by w--> -1..1 --bias_matrix--> 0..1
//
// The last is the shadow coordinate: u and v say where in the map, z is the depth to compare with what is stored there.
//
// All lengths are metres, also those of biases: a bias is measured in texels of the map, made metres by the texel's
// width at the point, and moves the point before it is looked up. So it means the same in a scene of a millimetre and
// in one of a hundred kilometres, under a sun and under a spot light, at 16 bits of depth and at 32.
//
// In depth_pass.glsl (vertex shader):
//
//   vec4 depth_pass_position(vec3 position)
//       The clip position, as the light sees it, of a corner in object space. u_model takes it to world space;
//       u_light_view and u_light_projection are what your C++ functions returned. (u_view and u_projection, which are
//       the camera's elsewhere, have no value here: the map has nothing to do with it.)
//
// In shadow_mapping.glsl (fragment shader):
//
//   vec3 shadow_coordinate(mat4 world_to_map, vec3 position)
//       (u, v, z) after the division by w. Behind the light, where w <= 0, there is no such point: (0, 0, 2). z is
//       otherwise at most 1: what lies beyond the far plane is compared as if it lay on it, and is in the shadow of
//       what stands before.
//   float map_width(ShadowLight light, float depth)
//       How many metres the map covers, from edge to edge, at this depth (metres along the light's direction): twice
//       the depth times the half-angle's tangent for a spot, the same everywhere for a sun. light.half_width holds the
//       tangent, or half the width.
//   float lit(vec3 coordinate, int layer)
//       One comparison with the map of this layer: 1 where coordinate.z <= the stored depth, otherwise 0, and 1 where
//       coordinate.z > 1. With COMPARE defined, u_shadow_maps is a sampler2DArrayShadow: it compares the four nearest
//       texels and mixes the answers (bilinear), and takes the depth as the fourth component.
//   vec3 constant_bias(vec3 position, vec3 to_light, float amount)
//       The position, `amount` metres nearer to the light.
//   vec3 slope_bias(vec3 position, vec3 normal, vec3 to_light, vec3 axis, float amount)
//       amount * sin(alpha) / cos(theta) metres nearer to the light: alpha is the angle between the normal and `axis`,
//       the direction against which the light looks (the map's texels are square to it), theta the angle between the
//       normal and to_light. For a sun both are one angle, and this is its tangent. cos(theta) counts as at least 0.01.
//       A zero normal moves nothing.
//   vec3 normal_offset(vec3 position, vec3 normal, vec3 axis, float amount)
//       amount * sin(alpha) metres along the normal, alpha as above. A zero normal moves nothing.
//   vec2 plane_slope(vec3 dx, vec3 dy)                                               (further)
//       (dz/du, dz/dv) of the plane that the surface is in the map's space: dx and dy are how the shadow coordinate
//       changes from pixel to pixel. Solves s.x du + s.y dv = dz for both. Where the two directions are parallel in the
//       map (|determinant| <= 1e-6 |dx.xy| |dy.xy|) it is (0, 0); components are at most 100 either way.
//   float pcf(vec3 coordinate, vec2 slope, int layer)
//       Percentage-closer filtering (Reeves, Salesin, Cook 1987): the mean of PCF x PCF comparisons, one texel apart,
//       their middle at the coordinate. Each compares the depth that the plane has there: z + dot(slope, offset).
//   float linear_depth(ShadowLight light, float z)                                   (challenge)
//       Metres along the light's direction from a depth 0..1 as it is stored: n f / (f - z (f - n)) for a spot, n + z
//       (f - n) for a sun.
//   float blocker_depth(ShadowLight light, vec3 coordinate, vec2 slope, float search) (challenge)
//       The mean linear depth of those of SAMPLES texels that are nearer to the light than the plane is there (z +
//       dot(slope, offset)); -1 where none is. Sample i lies at coordinate.xy + sample_point(i) * search.
//   float penumbra_width(ShadowLight light, float receiver, float blocker)           (challenge)
//       How wide the half-shadow is, in metres on a receiver square to the light: (receiver - blocker) / blocker *
//       light.width for a spot, whose light is a square of that width; (receiver - blocker) * light.width for a sun,
//       whose width is the tangent of the angle that it spans (Fernando, "Percentage-closer soft shadows", 2005).
//       Depths are linear.
//   float pcss(ShadowLight light, vec3 coordinate, vec2 slope, float receiver)       (challenge)
//       `receiver` is the depth of the point before it was moved, metres along light.direction from light.eye. The
//       blockers are sought within the square through which the point sees the light at the near plane: (receiver -
//       near) / receiver * light.width metres wide there (a sun: (receiver - near) * light.width; never below 0), as a
//       share of the map's width at the near plane. Without blockers, or with coordinate.z > 1, 1; otherwise the mean
//       of SAMPLES calls of `lit` over a square as wide as the penumbra (at least 0), as a share of the map's width at
//       the receiver: at coordinate + (offset, dot(slope, offset)), offset = sample_point(i) * width.
//   float shadow_factor(ShadowLight light, vec3 position, vec3 normal, vec3 to_light)
//       The share of the light that reaches a point: 1 lit, 0 in shadow. Step 02's `shade` asks for it by
//       visible_from_spot and visible_from_directional. `normal` is of unit length, or zero. Bias by the define BIAS
//       with amount = u_bias * KERNEL * the width of a texel at the depth of the unmoved point: 0 none, 1 constant, 2
//       slope, 3 normal offset, 4 receiver plane. The coordinate is that of the moved point; where BIAS is not 0 its z
//       is lowered by u_depth_step, what rounding may part. Then pcf, or pcss where PCSS is defined. With BIAS == 4 and
//       with PCSS the slope is plane_slope(dFdx(coordinate), dFdy(coordinate)), and z is lowered by u_bias * RESIDUAL *
//       (|slope.x| + |slope.y|) / resolution as well: what the plane falls within the texel that stands for the point.
//       Otherwise the slope is zero.
#pragma once

#include "02-blinn-phong/blinn_phong.hpp"

namespace atelier::shadow_mapping {

/// Whatever is within `radius` metres of `centre`.
struct Sphere {
  glm::vec3 centre{0};
  float radius = 1;
};

/// What a light sees: a square pyramid before a spot, a square box before a sun. World space.
struct LightFrustum {
  bool orthographic = false;      ///< a sun's
  glm::vec3 eye{0};               ///< from where depth is measured
  glm::vec3 direction{0, -1, 0};  ///< of unit length: the way that it looks
  float extent = 1;               ///< half the angle of view, radians; orthographic: half the width, metres
  float near = 0.1f, far = 100;   ///< metres along the direction; a spot's above 0, a box's may be below
};

/// Depth maps of one size, one layer a light, and the framebuffer through which they are drawn. Names (numbers) of
/// objects that the receiver deletes.
struct ShadowMaps {
  GLuint texture = 0;  ///< a GL_TEXTURE_2D_ARRAY
  GLuint framebuffer = 0;
  int resolution = 0;  ///< texels a side
  int layers = 0;
};

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: the map and the pass that draws it. Both leave no texture bound.
// ---------------------------------------------------------------------------------------------------------------------

/// Makes the texture, resolution x resolution texels and `layers` layers of `internal_format` (GL_DEPTH_COMPONENT16,
/// GL_DEPTH_COMPONENT24 or GL_DEPTH_COMPONENT32F), and a framebuffer that has its layer 0 as depth and no colour (draw
/// and read buffer GL_NONE). Beyond its edges the texture is 1, the farthest depth (GL_CLAMP_TO_BORDER): what the light
/// does not see is not in its shadow. With `compare` false it is read as it is (GL_NEAREST, GL_NONE as compare mode),
/// otherwise compared and mixed (GL_LINEAR, GL_COMPARE_REF_TO_TEXTURE, GL_LEQUAL).
ShadowMaps make_shadow_maps(Gl& gl, int resolution, int layers, GLenum internal_format, bool compare);

/// Makes everything ready for drawing layer `layer`: framebuffer bound with that layer attached as depth, viewport all
/// of the map, depth test on (GL_LESS, writing), depth clamping on (GL_DEPTH_CLAMP: what stands before the near plane
/// is pressed onto it, and still casts its shadow), the layer cleared to 1. Culls front faces where asked, otherwise
/// nothing: open surfaces cast shadows from both sides.
void begin_depth_pass(Gl& gl, const ShadowMaps& maps, int layer, bool cull_front_faces);

// ---------------------------------------------------------------------------------------------------------------------
// Core 2: what the light sees
// ---------------------------------------------------------------------------------------------------------------------

/// The pyramid of a spot light at `position` around a sphere: it looks at the centre, its half-angle is asin(radius /
/// distance) (the cone that touches the sphere: atan would cut it), its planes are at distance - radius and distance +
/// radius. Where the light is within the sphere (distance <= radius), or where its own cone is narrower (outer_angle,
/// from `direction`, which has any length but zero), it looks along its direction instead with outer_angle as
/// half-angle, and its planes are those of the sphere along that direction. The half-angle is at least 0.001 and at
/// most 1.5 radians; far is at least 1e-6; near is at least far / 1000.
LightFrustum fit_spot(const glm::vec3& position, const glm::vec3& direction, float outer_angle, const Sphere& sphere);

/// World space to the light's space, which looks along -z as a camera does: step 01's look_at from `eye` along
/// `direction`, with +y up. Right also far from the world's origin, where `eye` + `direction` has lost the direction's
/// digits: so move the eye to the origin first, and turn there.
glm::mat4 light_view(const LightFrustum& frustum);

/// The light's space to clip space, square: step 01's perspective or orthographic.
glm::mat4 light_projection(const LightFrustum& frustum);

/// Takes -1..1 to 0..1 in x, y and z, also before the division by w.
glm::mat4 bias_matrix();

// ---------------------------------------------------------------------------------------------------------------------
// Further: a sun
// ---------------------------------------------------------------------------------------------------------------------

/// The box of a directional light around a sphere: its half-width the radius, its eye at `radius` metres from the
/// centre against the direction (any length but zero), planes at 0 and twice the radius. The radius counts as at least
/// 1e-6.
LightFrustum fit_sun(const glm::vec3& direction, const Sphere& sphere);

// ---------------------------------------------------------------------------------------------------------------------
// Challenge: shadows that stand still
// ---------------------------------------------------------------------------------------------------------------------

/// Moves an orthographic frustum to the grid of its own texels, so that shadows do not crawl along their edges while
/// what it is fitted to moves a little. First its half-width, with room for nearly half a texel on each side (1 +
/// 1/resolution), is rounded up to the next of the steps 2^(k/4), k whole, so that texels keep their size; then the eye
/// is moved square to the direction, to the nearest place whose x and y in the space of look_at(origin, direction, up)
/// are whole multiples of a texel (ties upwards: floor(x/texel + 1/2)). Perspective frusta stay as they are.
LightFrustum snap_to_texels(const LightFrustum& frustum, int resolution);

}  // namespace atelier::shadow_mapping
