// 02-blinn-phong: the contract. You write blinn_phong.cpp (what happens once, on the CPU) and blinn_phong.glsl (what
// happens for every pixel). The GLSL functions are declared in this file as comments; their types are in lights.glsl.
//
// The model (Blinn 1977, energy after Sloan and Hoffman in Real-Time Rendering):
//
//   L = kd * ambient + emission + sum over lights of  s * E * (kd + ks * N(n) * max(N.H, 0)^n) * max(N.L, 0)
//
// kd, ks: diffuse and specular colour of the material, n its exponent; N, L, V unit vectors along the normal, to the
// light and to the eye; H = normalize(L + V). E is the light that would arrive if nothing stood in its way, divided by
// pi (so that a white surface, lit from straight above by a light of colour 1, looks 1); s is its visibility, the share
// 0..1 that does arrive. N(n) is 1, or the factor that keeps the highlight's energy. Everything is linear light;
// encoding to sRGB happens once, at the end.
//
// In blinn_phong.glsl:
//
//   float attenuation(float distance, vec3 coefficients)
//       1 / (c.x + c.y d + c.z d^2); a distance below 0.001 m counts as 0.001 m.
//   float spot_cone(vec3 to_light, vec3 axis, float cos_inner, float cos_outer)
//       1 within the inner cone, 0 outside the outer one, smooth (3t^2 - 2t^3 in the cosine) between. to_light and axis
//       are unit vectors; the axis is the way that the light travels. Equal cosines: a hard edge, lit on it; cosines of
//       -1 lose no direction, though a rounded cosine may come out below.
//   float specular_normalisation(float exponent)
//       By the define NORMALISATION: 0 (none): 1;  1: (n + 8) / 8;  2 (exact at normal incidence):
//       (n + 2)(n + 4) / (8 (2^(-n/2) + n)). 0 <= n <= 1e6.
//   float highlight(vec3 normal, vec3 half_vector, float exponent)
//       max(N.H, 0)^n, for unit vectors, and 1 for an exponent of 0. By the define POWER: 0: pow of the cosine; 1:
//       stable at exponents where a cosine near 1 has lost its digits: exp(n/2 log(1 - s)) with s = |N x H|^2, and a
//       series for the logarithm where s is small (GLSL has no log1p), 0 where N.H <= 0; 2: u_power_table, the table
//       that power_table made, read at its texel centres (challenge).
//   vec3 reflected(vec3 normal, vec3 to_eye, vec3 to_light, Material m)
//       (kd + ks N(n) (N.H)^n) max(N.L, 0). Unit vectors. Nothing where N.L <= 0, no highlight where L = -V (no half
//       vector). Keep the highlight between #ifdef SPECULAR and #endif: materials without one then get a shader without
//       one.
//   vec3 arriving_from_point(PointLight light, vec3 position, out vec3 to_light)
//   vec3 arriving_from_spot(SpotLight light, vec3 position, out vec3 to_light)
//   vec3 arriving_from_direction(DirectionalLight light, vec3 position, out vec3 to_light)
//       E of one light at a position in world space, and the unit vector to the light. A light exactly at the position
//       gives no light and any unit vector.
//   vec3 shade(vec3 position, vec3 normal, vec3 eye, Material m)
//       The whole sum over all lights. Of each light arrives what its visibility lets through, which lights.glsl tells
//       by the light's number in its array: visible_from_point(i), visible_from_spot(i), visible_from_directional(i),
//       0 to 1. It is worked out before `shade` is called, so it may be asked for anywhere. Ambient light comes from
//       everywhere: it is never weakened. `normal` comes interpolated: make it a unit vector first; a zero normal or an
//       eye at the position leaves only the ambient part.
//   vec3 srgb_encode(vec3 linear), vec3 srgb_decode(vec3 encoded)
//       As the C++ functions below, for each component; negative values become 0.
#pragma once

#include <algorithm>
#include <vector>

#include "01-transforms/transforms.hpp"

namespace atelier::blinn_phong {

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: colour
// ---------------------------------------------------------------------------------------------------------------------

/// Linear light 0..1 to its sRGB code 0..1 (IEC 61966-2-1): 12.92 x up to 0.0031308, then 1.055 x^(1/2.4) - 0.055.
/// Negative values become 0; values above one go on along the curve.
float srgb_encode(float linear);

/// The inverse: x / 12.92 up to 0.04045, then ((x + 0.055) / 1.055)^2.4. Negative values become 0.
float srgb_decode(float encoded);

// ---------------------------------------------------------------------------------------------------------------------
// Core 2: textures
// ---------------------------------------------------------------------------------------------------------------------

/// The chain of ever smaller pictures below `base`, which comes first, down to 1x1: each level is max(1, w/2) by
/// max(1, h/2) pixels (rounded down), a pixel the mean of the 2x2 pixels of the level above it (where a side is 1, of
/// the 1x2 or 2x1; an odd last row or column is left out).
std::vector<Image> mipmaps(const Image& base);

/// Makes a 2D texture of format GL_RGBA32F from all `levels` (one, or a whole chain from `mipmaps`), with the wrap mode
/// in both directions and the filter: nearest, linear, or mipmap (linear when enlarged, GL_LINEAR_MIPMAP_LINEAR when
/// shrunk). An Image has its first row on top, OpenGL the texture coordinate (0,0) at the bottom: turn the rows.
/// GL_TEXTURE_MAX_LEVEL is levels.size() - 1. Returns the texture's name; leaves none bound.
GLuint upload_texture(Gl& gl, std::span<const Image> levels, Wrap wrap, Filter filter);

// ---------------------------------------------------------------------------------------------------------------------
// Core 3: spot lights
// ---------------------------------------------------------------------------------------------------------------------

/// (cos inner, cos outer) of angles from the axis, in radians, 0 <= inner <= outer <= pi. Equal angles must give equal
/// cosines, and an angle of pi exactly -1, so that a spot that shines all round loses nothing.
glm::vec2 cone_cosines(float inner_angle, float outer_angle);

// ---------------------------------------------------------------------------------------------------------------------
// Further: materials that keep energy
// ---------------------------------------------------------------------------------------------------------------------

/// Scales a material's diffuse and specular colour by one common factor, so that the largest component of their sum is
/// at most 1: the surface gives back no more than it got. Leaves materials alone that are within it; never changes the
/// hue.
void balance(glm::vec3& diffuse, glm::vec3& specular);

// ---------------------------------------------------------------------------------------------------------------------
// Challenge: a table for the power
// ---------------------------------------------------------------------------------------------------------------------

/// x^exponent at `size` points x = i / (size - 1), i = 0 .. size - 1, computed in double precision. Exponent 0 gives 1
/// everywhere. Throws std::invalid_argument where size < 2 or exponent < 0.
std::vector<float> power_table(float exponent, int size);

}  // namespace atelier::blinn_phong
