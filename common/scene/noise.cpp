#include "scene/noise.hpp"

namespace atelier {
namespace {

std::uint64_t mix_bits(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double fade(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

/// Faster than std::floor, which is a function call on baseline x86-64 (no rounding instruction).
std::int64_t floor_of(double x) {
  const auto toward_zero = std::int64_t(x);
  return toward_zero - (double(toward_zero) > x);
}

std::int64_t wrap(std::int64_t i, std::int64_t period) {
  if (i >= 0 && i < period) return i;  // the usual case; avoids an expensive division
  const std::int64_t rest = i % period;
  return rest < 0 ? rest + period : rest;
}

double to_01(std::uint64_t bits) {
  return double(bits >> 11) * 0x1p-53;
}

}  // namespace

std::uint64_t hash(std::uint64_t seed, std::int64_t x, std::int64_t y) {
  return mix_bits(mix_bits(mix_bits(seed) ^ std::uint64_t(x)) ^ std::uint64_t(y));
}

double hash01(std::uint64_t seed, std::int64_t x, std::int64_t y) {
  return double(hash(seed, x, y) >> 11) * 0x1p-53;
}

double value_noise(std::uint64_t seed, glm::dvec2 p, glm::ivec2 period) {
  const std::int64_t cell_x = floor_of(p.x), cell_y = floor_of(p.y);
  const double u = fade(p.x - double(cell_x)), v = fade(p.y - double(cell_y));
  const std::int64_t x0 = wrap(cell_x, period.x), x1 = x0 + 1 < period.x ? x0 + 1 : 0;
  const std::int64_t y0 = wrap(cell_y, period.y), y1 = y0 + 1 < period.y ? y0 + 1 : 0;
  // hash01() of the cell's four corners; common parts are computed once.
  const std::uint64_t base = mix_bits(seed);
  const std::uint64_t left = mix_bits(base ^ std::uint64_t(x0)), right = mix_bits(base ^ std::uint64_t(x1));
  const auto corner = [](std::uint64_t column, std::int64_t y) { return to_01(mix_bits(column ^ std::uint64_t(y))); };
  const double below = (1 - u) * corner(left, y0) + u * corner(right, y0);
  const double above = (1 - u) * corner(left, y1) + u * corner(right, y1);
  return (1 - v) * below + v * above;
}

double fractal_noise(std::uint64_t seed, glm::dvec2 p, glm::ivec2 period, int octaves) {
  double sum = 0, weight = 1, total = 0;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += weight * value_noise(seed + octave, p, period);
    total += weight;
    weight /= 2;
    p *= 2.0;
    period *= 2;
  }
  return sum / total;
}

}  // namespace atelier
