// Random numbers that depend on their arguments alone: no state, so every order and every thread gets the same. Given.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace atelier::artstyles {

/// Three numbers, each evenly distributed over 0 .. 2^32 - 1 and independent of those of other arguments: pcg3d
/// (Jarzynski and Olano, "Hash Functions for GPU Rendering", 2020).
inline glm::uvec3 random_numbers(std::uint32_t seed, int column, int row) {
  glm::uvec3 v(std::uint32_t(column), std::uint32_t(row), seed);
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}

}  // namespace atelier::artstyles
