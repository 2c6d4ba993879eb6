// Fits the shift of a whole picture.
#include <cmath>

#include "base/error.hpp"
#include "image/compare.hpp"

namespace atelier {
namespace {

/// The sums of the normal equations: A = sum g g^T (symmetric), b = sum g (yours - reference).
struct Normal {
  double xx = 0, xy = 0, yy = 0, bx = 0, by = 0;
};

/// One row of the mean brightness of both pictures: their sum, and yours minus the reference.
void load(const Image& yours, const Image& reference, int y, float* __restrict sum, float* __restrict difference) {
  for (int x = 0; x < yours.width(); ++x) {
    const Rgba &a = yours.at(x, y), &b = reference.at(x, y);
    const float mine = (a.r + a.g + a.b) * (1 / 3.0f), theirs = (b.r + b.g + b.b) * (1 / 3.0f);
    sum[x] = mine + theirs;
    difference[x] = mine - theirs;
  }
}

/// Adds one row's inner pixels. `sum` holds rows y - 1, y, y + 1; central differences of the mean of both pictures.
void add_row(const float* const (&sum)[3], const float* difference, int width, Normal& n) {
  Normal row;
  for (int x = 1; x < width - 1; ++x) {
    const double gx = (sum[1][x + 1] - sum[1][x - 1]) * 0.25f, gy = (sum[2][x] - sum[0][x]) * 0.25f, d = difference[x];
    if (!std::isfinite(gx * gx + gy * gy + d * d)) continue;
    row.xx += gx * gx, row.xy += gx * gy, row.yy += gy * gy, row.bx += gx * d, row.by += gy * d;
  }
  n.xx += row.xx, n.xy += row.xy, n.yy += row.yy, n.bx += row.bx, n.by += row.by;
}

/// Solves A s = -b by A's eigenvectors, ignoring a direction with almost no gradient.
Shift solve(const Normal& n) {
  const double mean = (n.xx + n.yy) / 2, radius = std::hypot((n.xx - n.yy) / 2, n.xy);
  const double strong = mean + radius, weak = mean - radius;
  // A single step of a hundredth from one pixel to the next would make `strong` 1e-4.
  constexpr double no_gradient = 1e-5, stripes = 1e-4;
  if (!(strong > no_gradient)) return {};
  const double angle = 0.5 * std::atan2(2 * n.xy, n.xx - n.yy), c = std::cos(angle), s = std::sin(angle);
  const double along = -(c * n.bx + s * n.by) / strong;
  const double across = weak > stripes * strong ? -(-s * n.bx + c * n.by) / weak : 0;
  return {c * along - s * across, s * along + c * across};
}

}  // namespace

double Shift::length() const {
  return std::hypot(x, y);
}

Shift fit_shift(const Image& yours, const Image& reference) {
  if (yours.empty() || !yours.same_size(reference))
    throw Error("A shift can be fitted only between two pictures of the same size.");
  const int width = yours.width(), height = yours.height();
  if (width < 3 || height < 3) return {};
  std::vector<float> sum[3], difference[3];
  for (int i = 0; i < 3; ++i) sum[i].resize(std::size_t(width)), difference[i].resize(std::size_t(width));
  Normal normal;
  for (int y = 0; y < height; ++y) {
    load(yours, reference, y, sum[y % 3].data(), difference[y % 3].data());
    if (y < 2) continue;
    const float* const rows[3] = {sum[(y - 2) % 3].data(), sum[(y - 1) % 3].data(), sum[y % 3].data()};
    add_row(rows, difference[(y - 1) % 3].data(), width, normal);
  }
  return solve(normal);
}

}  // namespace atelier
