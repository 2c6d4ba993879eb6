#include "10-artstyles/given/fast_stroke.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <map>
#include <tuple>
#include <vector>

namespace atelier {

using namespace artstyles;

namespace {

/// The pixels that a stroke covers, without its place: a stroke is convex, so they are one span in each row.
struct Stamp {
  struct Span {
    int first = 0, end = 0;  ///< columns from the start of the line
  };
  int top = 0;  ///< row, from the start of the line
  std::vector<Span> rows;
};

Stamp make_stamp(glm::ivec2 way, int radius) {
  const std::int64_t length = std::int64_t(way.x) * way.x + std::int64_t(way.y) * way.y,
                     reach = std::int64_t(radius) * radius;
  const auto covers = [&](std::int64_t x, std::int64_t y) {
    const std::int64_t along = x * way.x + y * way.y, across = x * way.y - y * way.x;
    if (along <= 0) return x * x + y * y <= reach;
    if (along >= length) return (x - way.x) * (x - way.x) + (y - way.y) * (y - way.y) <= reach;
    return across * across <= reach * length;
  };
  const int left = std::min(way.x, 0) - radius, right = std::max(way.x, 0) + radius;
  Stamp stamp{.top = std::min(way.y, 0) - radius, .rows = {}};
  for (int y = stamp.top; y <= std::max(way.y, 0) + radius; ++y) {
    Stamp::Span span{left, right + 1};
    while (span.first < span.end && !covers(span.first, y)) ++span.first;
    while (span.end > span.first && !covers(span.end - 1, y)) --span.end;
    stamp.rows.push_back(span);
  }
  return stamp;
}

/// Most strokes of a painting have one of a few hundred shapes.
const Stamp& stamp_of(glm::ivec2 way, int radius) {
  constexpr std::size_t most = 4096;
  thread_local std::map<std::tuple<int, int, int>, Stamp> stamps;
  if (stamps.size() > most) stamps.clear();
  const auto [found, is_new] = stamps.try_emplace({way.x, way.y, radius});
  if (is_new) found->second = make_stamp(way, radius);
  return found->second;
}

// Four pixels at a time: with these vectors GCC and Clang use one instruction for all their channels.
using Halves = std::uint16_t __attribute__((vector_size(16)));
using Pixels = std::int32_t __attribute__((vector_size(16)));

/// The bytes at even places (red, blue) and those at odd ones (green, opacity) are blended apart, in 16 bits each.
struct Paint {
  Halves even_added{}, even_kept{}, odd_added{}, odd_kept{};  ///< opacity * colour + 128, and the canvas's factor

  explicit Paint(const Stroke& stroke) {
    const auto added = [&](int channel) { return std::uint16_t(128 + stroke.opacity * stroke.colour[channel]); };
    const auto kept = std::uint16_t(255 - stroke.opacity);
    for (int i = 0; i < 8; ++i) {
      even_added[i] = added(i % 2 == 0 ? 0 : 2);
      even_kept[i] = kept;
      odd_added[i] = i % 2 == 0 ? added(1) : 128;  // a pixel's opacity stays
      odd_kept[i] = i % 2 == 0 ? kept : 255;
    }
  }

  /// n / 255, rounded, is (m + (m >> 8)) >> 8 with m = n + 128, for all n up to 255^2.
  static Halves divided(Halves m) { return (m + (m >> 8)) >> 8; }

  Pixels blended(Pixels pixels) const {
    const auto before = Halves(pixels);
    const Halves even = divided((before & 255) * even_kept + even_added);
    const Halves odd = divided((before >> 8) * odd_kept + odd_added);
    return Pixels(even | (odd << 8));
  }
};

Pixels load(const void* from) {
  Pixels loaded;
  std::memcpy(&loaded, from, sizeof loaded);
  return loaded;
}

/// A part of a row, within which four pixels may be read and written at once.
struct Run {
  glm::u8vec4* pixels;
  const int* parts;  ///< their regions, or null
  const Paint& paint;
  int region;

  /// Changes those of four pixels whose bits are set in `mask`.
  void four(int i, Pixels mask) const {
    const Pixels before = load(pixels + i);
    if (parts) {
      const Pixels numbers = load(parts + i);
      mask &= (numbers == 0) | (numbers == region);
    }
    const Pixels after = (paint.blended(before) & mask) | (before & ~mask);
    std::memcpy(pixels + i, &after, sizeof after);
  }
};

}  // namespace

void paint_stroke_fast(Picture& canvas, const Stroke& stroke, Rows rows, std::span<const int> regions) {
  const Stamp& stamp = stamp_of(stroke.to - stroke.from, stroke.radius);
  if (canvas.width < 4) return artstyles::paint_stroke(canvas, stroke, rows, regions);
  const Paint paint(stroke);
  const int top = stroke.from.y + stamp.top;
  const int last = std::min(rows.end, top + int(stamp.rows.size()));
  for (int y = std::max(rows.first, top); y < last; ++y) {
    const Stamp::Span& span = stamp.rows[std::size_t(y - top)];
    const int first = std::max(stroke.from.x + span.first, 0), end = std::min(stroke.from.x + span.end, canvas.width);
    if (first >= end) continue;
    const std::size_t row = std::size_t(y) * std::size_t(canvas.width);
    const Run run{&canvas.pixels[row], regions.empty() ? nullptr : &regions[row], paint, stroke.region};
    constexpr Pixels all = {-1, -1, -1, -1}, places = {0, 1, 2, 3};
    int x = first;
    for (; x + 4 <= end; x += 4) run.four(x, all);
    if (x == end) continue;
    // The last pixels, with those before them where the row ends: these stay.
    const int start = std::min(x, canvas.width - 4);
    run.four(start, (places >= x - start) & (places < end - start));
  }
}

}  // namespace atelier
