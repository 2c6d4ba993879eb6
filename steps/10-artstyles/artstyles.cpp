#include "10-artstyles/artstyles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace atelier::artstyles {

// TODO(10-artstyles): what your functions below share, if anything

std::vector<glm::ivec2> stroke_centres(glm::ivec2 size, glm::ivec2 cell, std::uint32_t seed) {
  // TODO(10-artstyles): one pixel of each cell
  static_cast<void>(size);
  static_cast<void>(cell);
  static_cast<void>(seed);
  return {};
}

int brush_radius(const Greys& greys, glm::ivec2 centre, const Brush& brush) {
  // TODO(10-artstyles): how much do the greys around it differ?
  static_cast<void>(greys);
  static_cast<void>(centre);
  return brush.largest;
}

void paint_stroke(Picture& canvas, const Stroke& stroke, Rows rows, std::span<const int> regions) {
  // TODO(10-artstyles): which pixels are near the line, and what becomes of them?
  static_cast<void>(canvas);
  static_cast<void>(stroke);
  static_cast<void>(rows);
  static_cast<void>(regions);
}

std::vector<int> regions(const Greys& greys, int threshold) {
  // TODO(10-artstyles): borders, then what is connected
  static_cast<void>(threshold);
  return std::vector<int>(greys.values.size(), 1);
}

}  // namespace atelier::artstyles
