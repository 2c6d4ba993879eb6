// Colour: from linear light to the codes of a display, and to perceptual colour spaces.
//
//   linear RGB  -- proportional to light; Rec. 709 primaries, white D65. What shaders compute in.
//   sRGB        -- the same, encoded by a curve of about equal visible steps. What files and screens store.
//   XYZ         -- CIE 1931, independent of any display; Y is luminance.
//   L*a*b*      -- roughly perceptually uniform: one unit is about one just noticeable difference.
//
// Sources: IEC 61966-2-1 (sRGB), ITU-R BT.709 (primaries, white), CIE 15 (L*a*b*).
#pragma once

#include <cstdint>

#include "image/image.hpp"

namespace atelier {

/// How a picture's numbers encode light.
enum class Encoding {
  linear,  ///< proportional to light
  srgb,    ///< sRGB-encoded, 0..1
  data,    ///< not colour: normals, depth, masks; never converted
};

/// The sRGB curve: 12.92 x up to 0.0031308, then 1.055 x^(1/2.4) - 0.055. Exact to rounding. Not clamped: the linear
/// part continues below 0, the power above 1; NaN and +infinity stay.
float srgb_encode(float linear);
double srgb_encode(double linear);

/// Its inverse: x / 12.92 up to 0.04045, then ((x + 0.055) / 1.055)^2.4. Outside 0..1 and for NaN as srgb_encode.
float srgb_decode(float encoded);
double srgb_decode(double encoded);

/// The sRGB code that an 8-bit file holds for a linear value: 255 times the encoded one, rounded; 0 below 0 and for
/// NaN, 255 above 1.
std::uint8_t srgb_code(float linear);

/// The linear value of an sRGB code.
float linear_of_code(std::uint8_t code);

/// The curve on red, green and blue; opacity does not change.
Rgba srgb_encode(const Rgba& linear);
Rgba srgb_decode(const Rgba& encoded);
Image srgb_encode(const Image& linear);
Image srgb_decode(const Image& encoded);

/// Relative luminance Y of a linear colour, 1 for white: 0.2126 r + 0.7152 g + 0.0722 b (BT.709).
inline float luminance(const Rgba& linear) {
  return 0.2126f * linear.r + 0.7152f * linear.g + 0.0722f * linear.b;
}

struct Xyz {
  double x = 0, y = 0, z = 0;  ///< white has y = 1
};

struct Lab {
  double l = 0, a = 0, b = 0;  ///< l 0..100, a green to red, b blue to yellow
};

/// A 3x3 matrix by rows: element [row][column] is the weight of input `column` in output `row`.
struct Matrix3 {
  double m[3][3] = {};
};

namespace detail {

constexpr Matrix3 inverse(const Matrix3& a) {
  const auto& m = a.m;
  const double c0 = m[1][1] * m[2][2] - m[1][2] * m[2][1], c1 = m[1][2] * m[2][0] - m[1][0] * m[2][2],
               c2 = m[1][0] * m[2][1] - m[1][1] * m[2][0], determinant = m[0][0] * c0 + m[0][1] * c1 + m[0][2] * c2;
  Matrix3 r{{{c0, m[0][2] * m[2][1] - m[0][1] * m[2][2], m[0][1] * m[1][2] - m[0][2] * m[1][1]},
             {c1, m[0][0] * m[2][2] - m[0][2] * m[2][0], m[0][2] * m[1][0] - m[0][0] * m[1][2]},
             {c2, m[0][1] * m[2][0] - m[0][0] * m[2][1], m[0][0] * m[1][1] - m[0][1] * m[1][0]}}};
  for (auto& row : r.m)
    for (double& value : row) value /= determinant;
  return r;
}

/// The matrix whose columns are the primaries' XYZ, scaled so that their sum is the white point.
constexpr Matrix3 rgb_to_xyz(const double (&primaries)[3][2], const Xyz& white) {
  Matrix3 columns;
  for (int i = 0; i < 3; ++i) {
    const double x = primaries[i][0], y = primaries[i][1];
    columns.m[0][i] = x / y;
    columns.m[1][i] = 1;
    columns.m[2][i] = (1 - x - y) / y;
  }
  const Matrix3 solve = inverse(columns);
  for (int i = 0; i < 3; ++i) {
    const double scale = solve.m[i][0] * white.x + solve.m[i][1] * white.y + solve.m[i][2] * white.z;
    for (auto& row : columns.m) row[i] *= scale;
  }
  return columns;
}

}  // namespace detail

/// Daylight of 6500 K as XYZ with y = 1, from its chromaticity x = 0.3127, y = 0.3290.
inline constexpr Xyz white_d65{0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290};

/// Linear RGB with Rec. 709 primaries to XYZ and back; derived from the chromaticities, so they are exact inverses.
inline constexpr Matrix3 linear_to_xyz_matrix =
    detail::rgb_to_xyz({{0.640, 0.330}, {0.300, 0.600}, {0.150, 0.060}}, white_d65);
inline constexpr Matrix3 xyz_to_linear_matrix = detail::inverse(linear_to_xyz_matrix);

Xyz linear_to_xyz(const Rgba& linear);
Rgba xyz_to_linear(const Xyz& xyz);  ///< opacity 1; may lie outside 0..1

/// L*a*b* relative to D65; the linear part of its curve continues below 0, so every finite input has a finite output.
Lab xyz_to_lab(const Xyz& xyz);

}  // namespace atelier
