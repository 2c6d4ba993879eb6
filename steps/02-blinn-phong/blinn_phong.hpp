// 02-blinn-phong: the contract of blinn_phong.cpp, which runs once, on the CPU. You also write blinn_phong.glsl, which
// runs for every pixel: there the contract of each function is the comment above it. The GLSL types are in
// given/lights.glsl.
//
// The model (Blinn 1977, energy after Sloan and Hoffman in Real-Time Rendering; derivation: handout, sections 1 to 4):
//
//   L = kd * ambient + emission + sum over lights of  s * E * (kd + ks * N(n) * max(N.H, 0)^n) * max(N.L, 0)
//
// kd, ks: diffuse and specular colour of the material, n its exponent.
// N, L, V: unit vectors along the normal, to the light and to the eye; H = normalize(L + V).
// E: the light that would arrive if nothing were in the way, divided by pi. So a white surface looks 1 where a light of
//    colour 1 shines straight onto it.
// s: the visibility of the light, 0 to 1: the fraction of E that really arrives.
// N(n): 1, or a factor that keeps the energy of the highlight constant.
// All colours are linear light. Encoding to sRGB happens once, at the end.
#pragma once

#include <algorithm>
#include <vector>

#include "01-transforms/transforms.hpp"

namespace atelier::blinn_phong {

// ---------------------------------------------------------------------------------------------------------------------
// Core 1: colour
// ---------------------------------------------------------------------------------------------------------------------

/// Linear light x, 0 to 1, to its sRGB code, 0 to 1 (IEC 61966-2-1): 12.92 x up to x = 0.0031308, above that
/// 1.055 x^(1/2.4) - 0.055, also for values above 1. Negative values become 0. Handout, section 7.
float srgb_encode(float linear);

/// The inverse: a code to linear light. The straight part ends at the code 0.04045. Negative values become 0; values
/// above 1 follow the curve. The code 0.5 is 0.2140 of linear light.
float srgb_decode(float encoded);

// ---------------------------------------------------------------------------------------------------------------------
// Core 2: textures
// ---------------------------------------------------------------------------------------------------------------------

/// All levels of a mipmap, from `base` (the first) down to 1x1. A level of w x h pixels is followed by one of
/// max(1, w/2) x max(1, h/2), rounded down. Pixel (x, y) of a level is the mean of the 2x2 pixels from (2x, 2y) of the
/// level before; where a side is 1, of the two that exist. So an odd last row or column is ignored. Handout, section 6.
std::vector<Image> mipmaps(const Image& base);

/// Makes a 2D texture of format GL_RGBA32F from `levels` (one level, or all of `mipmaps`) and returns its name. The
/// wrap mode holds for both directions. Filters: nearest; linear; mipmap (linear where the texture is enlarged,
/// GL_LINEAR_MIPMAP_LINEAR where it is shrunk). GL_TEXTURE_MAX_LEVEL is the last level. Image row 0 is the top row,
/// but the texture coordinate (0, 0) is the lower left corner. Leaves no texture bound. Handout, section 6.
GLuint upload_texture(Gl& gl, std::span<const Image> levels, Wrap wrap, Filter filter);

// ---------------------------------------------------------------------------------------------------------------------
// Core 3: spot lights
// ---------------------------------------------------------------------------------------------------------------------

/// (cos inner, cos outer). The angles are measured from the axis, in radians, 0 <= inner <= outer <= pi. Equal angles
/// give equal cosines, and the float nearest to pi gives exactly -1, so that a spot of 180 degrees shines everywhere.
glm::vec2 cone_cosines(float inner_angle, float outer_angle);

// ---------------------------------------------------------------------------------------------------------------------
// Further: materials that keep energy
// ---------------------------------------------------------------------------------------------------------------------

/// Makes a material reflect no more light than it gets. Where the largest component of diffuse + specular is above 1,
/// both colours are scaled by one common factor, so that this component becomes 1 and the hue stays. Otherwise nothing
/// changes. Handout, section 4.
void balance(glm::vec3& diffuse, glm::vec3& specular);

// ---------------------------------------------------------------------------------------------------------------------
// Challenge: a table for the power
// ---------------------------------------------------------------------------------------------------------------------

/// x^exponent at `size` evenly spaced x: the first entry belongs to x = 0, the last to x = 1. Computed in double
/// precision. Exponent 0 gives 1 everywhere. Throws std::invalid_argument where size < 2 or exponent < 0 (or NaN).
std::vector<float> power_table(float exponent, int size);

}  // namespace atelier::blinn_phong
