#include "10-artstyles/given/painter.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "10-artstyles/given/fast_stroke.hpp"
#include "10-artstyles/given/random.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"

namespace atelier {

using namespace artstyles;

StrokeFunctions student_strokes() {
  return {.centres = stroke_centres, .radius = brush_radius, .paint = paint_stroke, .regions = regions};
}

Greys greys_of(const Picture& picture) {
  Greys greys{picture.width, picture.height, {}};
  greys.values.reserve(picture.pixels.size());
  for (const glm::u8vec4& p : picture.pixels)  // the weights of Rec. 709, in 256ths
    greys.values.push_back(std::uint8_t((54 * p.r + 183 * p.g + 19 * p.b + 128) / 256));
  return greys;
}

StrokeFunctions fast_strokes() {
  StrokeFunctions functions = student_strokes();
  functions.paint = paint_stroke_fast;
  return functions;
}

namespace {

/// From the colours of 64 pixels: the picture decides, not the time.
std::uint32_t seed_of(const Picture& picture) {
  std::uint32_t seed = 0;
  for (int i = 0; i < 64; ++i) {
    const int x = (2 * (i % 8) + 1) * picture.width / 16, y = (2 * (i / 8) + 1) * picture.height / 16;
    const glm::u8vec4& p = picture.pixels[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)];
    seed = random_numbers(seed, p.r + 256 * p.g + 65536 * p.b, i).x;
  }
  return seed;
}

/// The numbers 0 .. count - 1, each once, neighbours far apart: multiples of a step near the golden section of count.
std::vector<std::size_t> scattered(std::size_t count) {
  std::size_t step = std::max<std::size_t>(1, std::size_t(0.618 * double(count)));
  while (std::gcd(step, count) > 1) ++step;
  std::vector<std::size_t> order;
  for (std::size_t i = 0, at = 0; i < count; ++i, at = (at + step) % count) order.push_back(at);
  return order;
}

/// Half of a stroke's line.
glm::ivec2 half_line(const Greys& greys, glm::ivec2 centre, double half_length, std::uint32_t random) {
  const auto grey = [&](int x, int y) {
    const int u = std::clamp(centre.x + x, 0, greys.width - 1), v = std::clamp(centre.y + y, 0, greys.height - 1);
    return int(greys.values[std::size_t(v) * std::size_t(greys.width) + std::size_t(u)]);
  };
  glm::ivec2 gradient(0);
  for (int i = -1; i <= 1; ++i)
    gradient += (2 - i * i) * glm::ivec2(grey(1, i) - grey(-1, i), grey(i, 1) - grey(i, -1));
  if (gradient == glm::ivec2(0)) gradient = glm::ivec2(int(random & 31) - 16, int(random >> 5 & 31) - 16);
  if (gradient == glm::ivec2(0)) gradient = glm::ivec2(0, 1);
  const glm::dvec2 along = glm::dvec2(-gradient.y, gradient.x) * (half_length / glm::length(glm::dvec2(gradient)));
  return {int(std::lround(along.x)), int(std::lround(along.y))};
}

/// Equal parts of 0 .. count - 1, one for each thread.
template <class Task>
void in_parts(std::size_t count, int threads, const Task& task) {
  const auto parts = std::size_t(threads);
  for_each_parallel(parts, threads, [&](std::size_t part) { task(count * part / parts, count * (part + 1) / parts); });
}

constexpr int band_rows = 64;

struct Painter {
  const Picture& picture;
  const Painting& how;
  const StrokeFunctions& functions;
  const Greys greys = greys_of(picture);
  const std::vector<int> parts = how.confined ? functions.regions(greys, how.border) : std::vector<int>();

  std::size_t index(glm::ivec2 place) const {
    return std::size_t(place.y) * std::size_t(picture.width) + std::size_t(place.x);
  }

  std::vector<glm::ivec2> centres(std::uint32_t seed) const {
    const glm::uvec3 random = random_numbers(seed, -1, -1);
    const auto side = [&](std::uint32_t number) {
      return std::max(1, 3 * how.grid / 4 + int(std::uint64_t(number) * std::uint64_t(how.grid / 2 + 1) >> 32));
    };
    const glm::ivec2 size(picture.width, picture.height);
    std::vector<glm::ivec2> found = functions.centres(size, {side(random.x), side(random.y)}, seed);
    for (const glm::ivec2& c : found)
      if (c.x < 0 || c.y < 0 || c.x >= size.x || c.y >= size.y)
        throw Error(fmt::format("stroke_centres returned ({}, {}) for a picture of {} x {}", c.x, c.y, size.x, size.y));
    return found;
  }

  Stroke stroke(glm::ivec2 centre, std::uint32_t seed) const {
    const int radius = functions.radius(greys, centre, how.brush);
    if (radius < how.brush.smallest || radius > how.brush.largest)
      throw Error(
          fmt::format("brush_radius returned {} (allowed: {} to {})", radius, how.brush.smallest, how.brush.largest));
    const std::uint32_t random = random_numbers(seed, centre.x, centre.y).z;
    const glm::ivec2 half = half_line(greys, centre, how.length * radius / 2, random);
    return {.from = centre - half,
            .to = centre + half,
            .radius = radius,
            .colour = picture.pixels[index(centre)],
            .opacity = how.opacity,
            .region = parts.empty() ? 0 : parts[index(centre)]};
  }

  std::vector<Stroke> strokes(std::uint32_t seed) const {
    const std::vector<glm::ivec2> places = centres(seed);
    const std::vector<std::size_t> order = scattered(places.size());
    std::vector<Stroke> all(places.size());
    in_parts(all.size(), how.threads, [&](std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) all[i] = stroke(places[order[i]], seed);
    });
    return all;
  }

  /// Those that reach into each band of rows.
  std::vector<std::vector<const Stroke*>> by_band(const std::vector<Stroke>& all) const {
    std::vector<std::vector<const Stroke*>> bands(std::size_t((picture.height + band_rows - 1) / band_rows));
    for (const Stroke& stroke : all) {
      const int top = std::max(std::min(stroke.from.y, stroke.to.y) - stroke.radius, 0);
      const int bottom = std::min(std::max(stroke.from.y, stroke.to.y) + stroke.radius, picture.height - 1);
      for (int band = top / band_rows; band <= bottom / band_rows; ++band) bands[std::size_t(band)].push_back(&stroke);
    }
    return bands;
  }

  Picture paint() const {
    Picture canvas = picture;
    const std::uint32_t seed = seed_of(picture);
    for (int i = 0; i < how.iterations; ++i) {
      const std::vector<Stroke> all = strokes(random_numbers(seed, i, -1).x);
      // A band of rows after another, by whichever thread is free: the order of strokes is the same for every pixel,
      // and a band stays in the cache while all its strokes are painted.
      const std::vector<std::vector<const Stroke*>> bands = by_band(all);
      for_each_parallel(bands.size(), how.threads, [&](std::size_t band) {
        const int first = int(band) * band_rows;
        const Rows rows{first, std::min(first + band_rows, picture.height)};
        for (const Stroke* stroke : bands[band]) functions.paint(canvas, *stroke, rows, parts);
      });
    }
    return canvas;
  }
};

}  // namespace

Picture painted(const Picture& picture, const Painting& how, const StrokeFunctions& functions) {
  const Painter painter{picture, how, functions};
  if (how.confined && painter.parts.size() != picture.pixels.size())
    throw Error(fmt::format("regions returned {} numbers for {} pixels", painter.parts.size(), picture.pixels.size()));
  return painter.paint();
}

}  // namespace atelier
