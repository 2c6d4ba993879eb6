#include "scene/textures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "base/error.hpp"
#include "scene/noise.hpp"
#include "scene/texture_detail.hpp"

namespace atelier {

using texture_detail::ramp;
using texture_detail::require;

namespace {

glm::dvec3 rgb(const Rgba& c) {
  return {c.r, c.g, c.b};
}

Rgba pixel(const glm::dvec3& c) {
  return {float(c.r), float(c.g), float(c.b), 1};
}

/// A square picture from a colour function evaluated at pixel centres; u to the right and v up, both 0..1.
template <class Colour>
Image paint(int size, const Colour& colour) {
  Image image(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) image.at(x, y) = pixel(colour((x + 0.5) / size, 1 - (y + 0.5) / size));
  return image;
}

double fraction(double x) {
  return x - std::floor(x);
}

/// Up and down between 0 and 1 with period 1, 0 at the integers.
double triangle_wave(double x) {
  return 1 - std::abs(2 * fraction(x) - 1);
}

}  // namespace

Image make_checker(const CheckerTexture& texture) {
  require("checker", "size", texture.size, 1, 8192);
  require("checker", "squares", texture.squares, 1, texture.size);
  return paint(texture.size, [&](double u, double v) {
    const bool odd = (int(u * texture.squares) + int(v * texture.squares)) % 2 != 0;
    return rgb(odd ? texture.second : texture.first);
  });
}

Image make_uv_grid(int size) {
  require("uv grid", "size", size, 16, 8192);
  constexpr double frame = 0.03, half_line = 0.003;
  return paint(size, [](double u, double v) -> glm::dvec3 {
    if (v > 1 - frame) return {1, 1, 1};
    if (v < frame) return {0, 0, 0};
    if (u < frame) return {0, 0.7, 0.9};
    if (u > 1 - frame) return {0.9, 0, 0.7};
    // The arrow: a shaft and a head that narrows towards its tip.
    const double aside = std::abs(u - 0.5);
    const bool shaft = aside < 0.04 && v > 0.25 && v < 0.6;
    const bool head = v >= 0.6 && v < 0.8 && aside < 0.8 * (0.8 - v);
    if (shaft || head) return {1, 1, 1};
    const auto on_line = [](double x) { return std::abs(x * 10 - std::floor(x * 10 + 0.5)) < 10 * half_line; };
    const double shade = on_line(u) || on_line(v) ? 0.35 : 1;
    return shade * glm::dvec3(0.05 + 0.8 * u, 0.05 + 0.8 * v, 0.2);
  });
}

Image make_dots(const DotsTexture& texture) {
  require("dots", "size", texture.size, 1, 8192);
  require("dots", "dots", texture.dots, 2, 256);
  require("dots", "radius", texture.radius, 0.01, 0.5);
  if (texture.dots % 2 != 0) throw Error(fmt::format("dots: dots {} (allowed: even numbers, 2..256)", texture.dots));
  const double edge = 0.5 * texture.dots / texture.size;  // half a pixel, in units of the dot spacing
  return paint(texture.size, [&](double u, double v) {
    const double row = std::floor(v * texture.dots);
    const glm::dvec2 from_dot(fraction(u * texture.dots + 0.5 * std::fmod(row, 2)) - 0.5,
                              fraction(v * texture.dots) - 0.5);
    const double outside = ramp(texture.radius - edge, texture.radius + edge, glm::length(from_dot));
    return glm::mix(rgb(texture.dot), rgb(texture.ground), outside);
  });
}

Image make_wood(const WoodTexture& texture) {
  require("wood", "size", texture.size, 1, 8192);
  require("wood", "boards", texture.boards, 1, 64);
  const glm::dvec3 early(0.52, 0.28, 0.12), late(0.27, 0.11, 0.04);
  return paint(texture.size, [&](double u, double v) {
    const double across = v * texture.boards;
    const auto board = std::int64_t(across);
    const double in_board = fraction(across);
    const std::uint64_t seed = hash(texture.seed, board, 0);
    // Annual rings cut lengthwise: the distance from a slowly varying centre, in ring widths.
    const double wander = fractal_noise(seed, {2 * u, 1.7 * in_board}, {2, 64}, 3);
    const double rings = 7 * (in_board + 1.4 * wander + 3 * hash01(seed, 1, 0));
    const double dark = ramp(0.35, 0.95, fraction(rings)) * (1 - ramp(0.95, 1.0, fraction(rings)));
    const double fibre = fractal_noise(seed + 7, {8 * u, 120 * in_board}, {8, 4096}, 2);
    const double tone = 0.8 + 0.4 * hash01(seed, 2, 0);
    const double gap = ramp(0.0, 0.012, std::min(in_board, 1 - in_board));
    return (0.15 + 0.85 * gap) * tone * (0.8 + 0.4 * fibre) * glm::mix(early, late, 0.75 * dark);
  });
}

Image make_marble(const MarbleTexture& texture) {
  require("marble", "size", texture.size, 1, 8192);
  require("marble", "bands", texture.bands, 1, 64);
  require("marble", "turbulence", texture.turbulence, 0, 8);
  const glm::dvec3 stone(0.82, 0.8, 0.76), vein(0.16, 0.17, 0.2);
  return paint(texture.size, [&](double u, double v) {
    const glm::dvec2 p(4 * u, 4 * v);
    const double bend = fractal_noise(texture.seed, p, {4, 4}, 6) - 0.5;
    const double wave = triangle_wave(texture.bands * (u + v) + 2 * texture.turbulence * bend);
    const double thin = wave * wave * wave * wave;  // makes veins narrow
    const double cloud = fractal_noise(texture.seed + 31, p, {4, 4}, 4);
    return glm::mix(stone * (0.85 + 0.2 * cloud), vein, 0.8 * thin);
  });
}

}  // namespace atelier
