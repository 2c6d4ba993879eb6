#include "10-artstyles/artstyles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace atelier::artstyles {

// >>> student: what your functions below share, if anything
namespace {

/// floor(random * count / 2^32)
int below(std::uint32_t random, int count) {
  return int(std::uint64_t(random) * std::uint64_t(count) >> 32);
}

}  // namespace
// --- skeleton
// <<< student

std::vector<glm::ivec2> stroke_centres(glm::ivec2 size, glm::ivec2 cell, std::uint32_t seed) {
  // >>> student: one pixel of each cell
  if (size.x < 0 || size.y < 0 || cell.x < 1 || cell.y < 1)
    throw std::invalid_argument("stroke_centres: a negative size, or a cell without pixels");
  std::vector<glm::ivec2> centres;
  for (int row = 0; row * cell.y < size.y; ++row)
    for (int column = 0; column * cell.x < size.x; ++column) {
      const glm::uvec2 random = random_numbers(seed, column, row);
      const glm::ivec2 centre(column * cell.x + below(random.x, cell.x), row * cell.y + below(random.y, cell.y));
      if (centre.x < size.x && centre.y < size.y) centres.push_back(centre);
    }
  return centres;
  // --- skeleton
  // | static_cast<void>(size);
  // | static_cast<void>(cell);
  // | static_cast<void>(seed);
  // | return {};
  // <<< student
}

int brush_radius(const Greys& greys, glm::ivec2 centre, const Brush& brush) {
  // >>> student: how much do the greys around it differ?
  std::int64_t count = 0, sum = 0, squares = 0;
  const int right = std::min(centre.x + brush.reach, greys.width - 1);
  const int low = std::min(centre.y + brush.reach, greys.height - 1);
  for (int y = std::max(centre.y - brush.reach, 0); y <= low; ++y)
    for (int x = std::max(centre.x - brush.reach, 0); x <= right; ++x) {
      const int grey = greys.values[std::size_t(y) * std::size_t(greys.width) + std::size_t(x)];
      ++count;
      sum += grey;
      squares += grey * grey;
    }
  // In whole numbers nothing is lost in the difference of two large squares.
  const double deviation = std::sqrt(double(count * squares - sum * sum));  // times count, as the sum is the mean's
  const double contrast = sum > 0 ? deviation / double(sum) : 0.0;
  const double part = std::min(contrast / double(brush.full), 1.0);
  return int(std::lround(brush.largest + part * (brush.smallest - brush.largest)));
  // --- skeleton
  // | static_cast<void>(greys);
  // | static_cast<void>(centre);
  // | return brush.largest;
  // <<< student
}

void paint_stroke(Picture& canvas, const Stroke& stroke, Rows rows, std::span<const int> regions) {
  // >>> student: which pixels are near the line, and what becomes of them?
  using Whole = std::int64_t;
  const glm::ivec2 way = stroke.to - stroke.from;
  const Whole length_squared = Whole(way.x) * way.x + Whole(way.y) * way.y;
  const Whole reach_squared = Whole(stroke.radius) * stroke.radius;
  const auto covers = [&](int x, int y) {
    const Whole px = x - stroke.from.x, py = y - stroke.from.y, along = px * way.x + py * way.y;
    if (along <= 0) return px * px + py * py <= reach_squared;
    const Whole qx = x - stroke.to.x, qy = y - stroke.to.y;
    if (along >= length_squared) return qx * qx + qy * qy <= reach_squared;
    const Whole across = px * way.y - py * way.x;
    return across * across <= reach_squared * length_squared;
  };
  const int top = std::max(std::min(stroke.from.y, stroke.to.y) - stroke.radius, rows.first);
  const int bottom = std::min(std::max(stroke.from.y, stroke.to.y) + stroke.radius, rows.end - 1);
  const int left = std::max(std::min(stroke.from.x, stroke.to.x) - stroke.radius, 0);
  const int right = std::min(std::max(stroke.from.x, stroke.to.x) + stroke.radius, canvas.width - 1);
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const std::size_t at = std::size_t(y) * std::size_t(canvas.width) + std::size_t(x);
      if (!covers(x, y) || (!regions.empty() && regions[at] != 0 && regions[at] != stroke.region)) continue;
      for (int channel = 0; channel < 3; ++channel) {
        std::uint8_t& code = canvas.pixels[at][channel];
        code = std::uint8_t((stroke.opacity * stroke.colour[channel] + (255 - stroke.opacity) * code + 127) / 255);
      }
    }
  // --- skeleton
  // | static_cast<void>(canvas);
  // | static_cast<void>(stroke);
  // | static_cast<void>(rows);
  // | static_cast<void>(regions);
  // <<< student
}

std::vector<int> regions(const Greys& greys, int threshold) {
  // >>> student: borders, then what is connected
  const auto grey = [&](int x, int y) {
    const int u = std::clamp(x, 0, greys.width - 1), v = std::clamp(y, 0, greys.height - 1);
    return int(greys.values[std::size_t(v) * std::size_t(greys.width) + std::size_t(u)]);
  };
  const auto is_border = [&](int x, int y) {
    int across = 0, down = 0;
    for (int i = -1; i <= 1; ++i) {
      const int weight = 2 - i * i;
      across += weight * (grey(x + 1, y + i) - grey(x - 1, y + i));
      down += weight * (grey(x + i, y + 1) - grey(x + i, y - 1));
    }
    return std::int64_t(across) * across + std::int64_t(down) * down > std::int64_t(threshold) * threshold;
  };
  // A forest: parent[n] is another number of the same region, or n itself at the root. Number 0 are the borders.
  std::vector<int> parent = {0};
  const auto root = [&](int n) {
    while (parent[std::size_t(n)] != n) n = parent[std::size_t(n)] = parent[std::size_t(parent[std::size_t(n)])];
    return n;
  };
  std::vector<int> numbers(greys.values.size(), 0);
  for (int y = 0; y < greys.height; ++y)
    for (int x = 0; x < greys.width; ++x) {
      if (is_border(x, y)) continue;
      const std::size_t at = std::size_t(y) * std::size_t(greys.width) + std::size_t(x);
      const int left = x > 0 ? root(numbers[at - 1]) : 0;
      const int above = y > 0 ? root(numbers[at - std::size_t(greys.width)]) : 0;
      numbers[at] = left ? left : above;
      if (left && above) parent[std::size_t(above)] = left;
      if (numbers[at]) continue;
      numbers[at] = int(parent.size());
      parent.push_back(numbers[at]);
    }
  for (int& number : numbers) number = root(number);
  return numbers;
  // --- skeleton
  // | static_cast<void>(threshold);
  // | return std::vector<int>(greys.values.size(), 1);
  // <<< student
}

}  // namespace atelier::artstyles
