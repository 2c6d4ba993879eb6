#include "10-artstyles/given/exact_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "10-artstyles/given/random.hpp"

namespace atelier {

using namespace artstyles;

namespace {

std::vector<glm::ivec2> exact_centres(glm::ivec2 size, glm::ivec2 cell, std::uint32_t seed) {
  std::vector<glm::ivec2> centres;
  const glm::ivec2 cells = (size + cell - 1) / cell;
  for (int i = 0; i < cells.x * cells.y; ++i) {
    const glm::ivec2 at(i % cells.x, i / cells.x);
    const glm::dvec2 part = glm::dvec2(random_numbers(seed, at.x, at.y)) / 4294967296.0;  // exact: 32 of 53 bits
    const glm::ivec2 centre = at * cell + glm::ivec2(glm::floor(part * glm::dvec2(cell)));
    if (centre.x < size.x && centre.y < size.y) centres.push_back(centre);
  }
  return centres;
}

/// Variance in two passes.
int exact_radius(const Greys& greys, glm::ivec2 centre, const Brush& brush) {
  std::vector<double> values;
  for (int y = 0; y < greys.height; ++y)
    for (int x = 0; x < greys.width; ++x)
      if (std::max(std::abs(x - centre.x), std::abs(y - centre.y)) <= brush.reach)
        values.push_back(greys.values[std::size_t(y * greys.width + x)]);
  double mean = 0, variance = 0;
  for (const double v : values) mean += v / double(values.size());
  for (const double v : values) variance += (v - mean) * (v - mean) / double(values.size());
  const double contrast = mean > 0 ? std::sqrt(variance) / mean : 0;
  return int(std::floor(brush.largest -
                        (brush.largest - brush.smallest) * std::min(contrast / double(brush.full), 1.0) + 0.5));
}

/// In units of 1 / |to - from|^2 all is whole. For places within 1000 pixels of the line.
bool near_line(glm::i64vec2 p, glm::i64vec2 from, glm::i64vec2 to, std::int64_t radius) {
  const auto dot = [](glm::i64vec2 a, glm::i64vec2 b) { return a.x * b.x + a.y * b.y; };
  const glm::i64vec2 way = to - from;
  const std::int64_t unit = std::max<std::int64_t>(dot(way, way), 1);
  const std::int64_t along = std::clamp<std::int64_t>(dot(p - from, way), 0, unit);
  const glm::i64vec2 away = (p - from) * unit - way * along;  // from the nearest point of the line, times unit
  return dot(away, away) <= radius * radius * unit * unit;
}

void exact_paint(Picture& canvas, const Stroke& stroke, Rows rows, std::span<const int> regions) {
  // A box with more than a stroke can cover.
  const int margin = stroke.radius + 2;
  const glm::ivec2 low = glm::min(stroke.from, stroke.to) - margin, high = glm::max(stroke.from, stroke.to) + margin;
  for (int y = std::max(rows.first, low.y); y < std::min(rows.end, high.y); ++y)
    for (int x = std::max(low.x, 0); x < std::min(high.x, canvas.width); ++x) {
      const auto at = std::size_t(y * canvas.width + x);
      const bool mine = regions.empty() || regions[at] == 0 || regions[at] == stroke.region;
      if (!mine || !near_line({x, y}, stroke.from, stroke.to, stroke.radius)) continue;
      const double share = stroke.opacity / 255.0;
      for (int c = 0; c < 3; ++c) {
        std::uint8_t& code = canvas.pixels[at][c];
        code =
            std::uint8_t(std::floor(share * stroke.colour[c] + (1 - share) * code + 0.5));  // n / 255: never half way
      }
    }
}

/// Numbers spread from pixel to pixel until nothing changes.
std::vector<int> exact_regions(const Greys& greys, int threshold) {
  const auto grey = [&](int x, int y) {
    return double(
        greys
            .values[std::size_t(std::clamp(y, 0, greys.height - 1) * greys.width + std::clamp(x, 0, greys.width - 1))]);
  };
  std::vector<int> numbers;
  for (int y = 0; y < greys.height; ++y)
    for (int x = 0; x < greys.width; ++x) {
      const double across = grey(x + 1, y - 1) + 2 * grey(x + 1, y) + grey(x + 1, y + 1) - grey(x - 1, y - 1) -
                            2 * grey(x - 1, y) - grey(x - 1, y + 1);
      const double down = grey(x - 1, y + 1) + 2 * grey(x, y + 1) + grey(x + 1, y + 1) - grey(x - 1, y - 1) -
                          2 * grey(x, y - 1) - grey(x + 1, y - 1);
      const bool border = across * across + down * down > double(threshold) * threshold;
      numbers.push_back(border ? 0 : int(numbers.size()) + 1);
    }
  for (bool changed = true; changed;) {
    changed = false;
    const auto take = [&](int x, int y, int u, int v) {
      if (u < 0 || v < 0 || u >= greys.width || v >= greys.height) return;
      int& mine = numbers[std::size_t(y * greys.width + x)];
      const int other = numbers[std::size_t(v * greys.width + u)];
      if (mine == 0 || other == 0 || other >= mine) return;
      mine = other;
      changed = true;
    };
    const auto visit = [&](int x, int y) {
      take(x, y, x - 1, y);
      take(x, y, x, y - 1);
      take(x, y, x + 1, y);
      take(x, y, x, y + 1);
    };
    for (int y = 0; y < greys.height; ++y)
      for (int x = 0; x < greys.width; ++x) visit(x, y);
    for (int y = greys.height - 1; y >= 0; --y)
      for (int x = greys.width - 1; x >= 0; --x) visit(x, y);
  }
  return numbers;
}

}  // namespace

StrokeFunctions exact_strokes() {
  return {.centres = exact_centres, .radius = exact_radius, .paint = exact_paint, .regions = exact_regions};
}

}  // namespace atelier
