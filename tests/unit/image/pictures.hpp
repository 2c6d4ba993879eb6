// Small pictures that several tests look at.
#pragma once

#include <cmath>
#include <cstdint>

#include "image/image.hpp"

namespace atelier::test {

/// A pixel's value from a function of its centre, grey.
template <class Function>
Image grey(int width, int height, Function value) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float v = float(value(x, y));
      image.at(x, y) = {v, v, v, 1};
    }
  return image;
}

/// Soft colours with gradients in all directions, within 0.1..0.9, moved by (dx, dy) pixels to the right and down.
inline Image waves(int width, int height, double dx = 0, double dy = 0) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double u = x - dx, v = y - dy;
      image.at(x, y) = {float(0.5 + 0.4 * std::sin(0.21 * u) * std::cos(0.17 * v)),
                        float(0.5 + 0.4 * std::sin(0.13 * u + 0.19 * v)),
                        float(0.5 + 0.4 * std::cos(0.08 * u - 0.23 * v)), 1};
    }
  return image;
}

/// The same numbers on every machine, evenly from 0 to 1 (Knuth's 64-bit linear congruential generator).
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : state_(seed) {}
  float next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return float(state_ >> 40) / float(1 << 24);
  }

 private:
  std::uint64_t state_;
};

}  // namespace atelier::test
