// Stateless noise: a hash maps grid positions to numbers, so pixels can be computed in any order and give the same bits
// on any machine. Uses only integer operations and + - * / of doubles, which IEEE 754 rounds identically everywhere; no
// sine, no power.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace atelier {

/// 64 well-mixed bits from three numbers: the finalizer of splitmix64 (Steele, Lea, Flood, "Fast splittable
/// pseudorandom number generators", 2014) applied to each in turn.
std::uint64_t hash(std::uint64_t seed, std::int64_t x, std::int64_t y);

/// The same as a number, 0 <= r < 1, in steps of 2^-53.
double hash01(std::uint64_t seed, std::int64_t x, std::int64_t y);

/// Smooth noise 0..1: hashed values at the integer grid, blended by 6t^5 - 15t^4 + 10t^3 (Perlin, "Improving noise",
/// 2002: continuous second derivative). Repeats after `period` grid cells along x and y; each at least 1.
double value_noise(std::uint64_t seed, glm::dvec2 p, glm::ivec2 period);

/// Sum of `octaves` noises, each at twice the frequency and half the weight, scaled to 0..1. Repeats after `period`.
double fractal_noise(std::uint64_t seed, glm::dvec2 p, glm::ivec2 period, int octaves);

}  // namespace atelier
