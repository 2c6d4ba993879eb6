#include "image/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.hpp"

namespace atelier {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

void check(const Image& yours, const Image& reference, double delta = 0) {
  if (yours.empty() || !yours.same_size(reference))
    throw Error(fmt::format("Only pictures of the same size can be compared, not {} x {} and {} x {} pixels.",
                            yours.width(), yours.height(), reference.width(), reference.height()));
  if (!(delta >= 0)) throw Error(fmt::format("A tolerance of {} is not possible: it is 0 or more.", delta));
}

/// Largest of three distances, each >= 0; infinite where one is NaN.
float largest(float r, float g, float b) {
  const float rg = r > g ? r : g, all = rg > b ? rg : b;
  return r + g + b < infinite ? all : infinite;  // the sum propagates NaN, which comparisons would miss
}

// Each measure computes the distance of two pixels (in an inner unit that grows with its own), the distance of a pixel
// from the range of nine pixels, and the limit in the inner unit.

/// Levels and numbers: channel by channel.
struct Channels {
  float scale;  // units per 1
  double unit(float distance) const { return distance * scale; }

  static float distance(const Rgba& a, const Rgba& b) {
    return largest(std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b));
  }

  struct Span {
    Rgba low, high;
  };
  static Span start(const Rgba& p) { return {p, p}; }
  static void widen(Span& s, const Rgba& p) {
    s.low = {std::min(s.low.r, p.r), std::min(s.low.g, p.g), std::min(s.low.b, p.b)};
    s.high = {std::max(s.high.r, p.r), std::max(s.high.g, p.g), std::max(s.high.b, p.b)};
  }
  static float outside(float value, float low, float high) {
    const float clamped = value < low ? low : value > high ? high : value;
    return std::abs(value - clamped);
  }
  static float distance(const Rgba& p, const Rgba* const (&rows)[3], int first, int last) {
    Span s = start(rows[1][first]);
    for (const Rgba* row : rows)
      for (int x = first; x <= last; ++x) widen(s, row[x]);
    return largest(outside(p.r, s.low.r, s.high.r), outside(p.g, s.low.g, s.high.g), outside(p.b, s.low.b, s.high.b));
  }
};

/// Directions: the chord between unit vectors, which grows with the angle and needs no arc cosine.
struct Directions {
  struct Unit {
    float x, y, z;
    float length;  ///< before normalisation
    bool none() const { return length < 0.02f; }
  };
  static Unit decode(const Rgba& p) {
    const float x = 2 * p.r - 1, y = 2 * p.g - 1, z = 2 * p.b - 1, length = std::sqrt(x * x + y * y + z * z);
    return {x / length, y / length, z / length, length};
  }
  static double unit(float chord) {
    return std::isfinite(chord) ? 2 * std::asin(std::min(chord / 2.0, 1.0)) * 180 / std::numbers::pi : infinite;
  }
  static float distance(const Rgba& a, const Rgba& b) {
    const Unit u = decode(a), v = decode(b);
    if (u.none() || v.none()) {
      if (u.none() == v.none()) return 0;
      return u.length + v.length < infinite ? 2.0f : infinite;  // false for a NaN
    }
    const float x = u.x - v.x, y = u.y - v.y, z = u.z - v.z, chord = std::sqrt(x * x + y * y + z * z);
    return chord <= 2.001f ? chord : infinite;  // false for a NaN
  }
  static float distance(const Rgba& p, const Rgba* const (&rows)[3], int first, int last) {
    float nearest = infinite;
    for (const Rgba* row : rows)
      for (int x = first; x <= last; ++x) nearest = std::min(nearest, distance(p, row[x]));
    return nearest;
  }
};

/// Fills in everything from `distance_at(x, y)`, in the measure's inner unit, and its `limit`.
template <class Metric, class DistanceAt>
Difference collect(const Image& image, const Metric& metric, float limit, DistanceAt distance_at) {
  Difference result;
  result.mask = Mask(image.width(), image.height());
  std::vector<float> distances(std::size_t(image.width()));
  float worst = 0;
  for (int y = 0; y < image.height(); ++y) {
    float* __restrict out = distances.data();
    for (int x = 0; x < image.width(); ++x) out[x] = distance_at(x, y);
    const auto over = result.mask.row(y);
    float row_worst = 0;
    for (int x = 0; x < image.width(); ++x) {
      over[std::size_t(x)] = out[x] > limit;
      row_worst = row_worst > out[x] ? row_worst : out[x];
    }
    if (row_worst > worst) {
      worst = row_worst;
      result.worst = {int(std::find(distances.begin(), distances.end(), worst) - distances.begin()), y};
    }
  }
  result.worst_distance = metric.unit(worst);
  result.over = result.mask.count();
  result.share = result.over / (double(image.width()) * image.height());
  result.blob = erode(result.mask).count();
  return result;
}

/// Calls `compare(metric, limit)` with the metric of `measure` and the limit of `delta`.
template <class Compare>
Difference with_metric(Measure measure, double delta, Compare compare) {
  constexpr double level_rounding = 1e-3, relative_rounding = 1e-6;
  switch (measure) {
    case Measure::level:
      return compare(Channels{255}, float((delta + level_rounding) / 255));
    case Measure::number:
      return compare(Channels{1}, float(delta * (1 + relative_rounding)));
    case Measure::degrees:
      break;
  }
  const double half = std::min(delta, 180.0) / 2 * std::numbers::pi / 180;
  return compare(Directions{}, float(2 * std::sin(half) * (1 + relative_rounding)));
}

}  // namespace

Difference compare_strict(const Image& yours, const Image& reference, Measure measure, double delta) {
  check(yours, reference, delta);
  return with_metric(measure, delta, [&](const auto& metric, float limit) {
    return collect(yours, metric, limit,
                   [&](int x, int y) { return metric.distance(yours.at(x, y), reference.at(x, y)); });
  });
}

Difference compare_robust(const Image& yours, const Image& reference, Measure measure, double delta) {
  check(yours, reference, delta);
  const int right = yours.width() - 1, bottom = yours.height() - 1;
  return with_metric(measure, delta, [&](const auto& metric, float limit) {
    return collect(yours, metric, limit, [&](int x, int y) {
      const Rgba* const rows[3] = {&reference.at(0, std::max(y - 1, 0)), &reference.at(0, y),
                                   &reference.at(0, std::min(y + 1, bottom))};
      return metric.distance(yours.at(x, y), rows, std::max(x - 1, 0), std::min(x + 1, right));
    });
  });
}

}  // namespace atelier
