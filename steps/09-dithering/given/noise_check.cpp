#include "09-dithering/given/noise_check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace atelier {

namespace {

/// The energies of a pattern of points, in double precision and without a limit of distance.
class Energies {
 public:
  explicit Energies(int size) : size_(size), has_point_(cells(), false), energy_(cells(), 0.0) {}

  void change(int cell, bool add) {
    has_point_[std::size_t(cell)] = add;
    for (int other = 0; other < int(cells()); ++other) {
      const double dx = distance(cell % size_, other % size_), dy = distance(cell / size_, other / size_);
      energy_[std::size_t(other)] += (add ? 1 : -1) * std::exp(-(dx * dx + dy * dy) / (2 * 1.5 * 1.5));
    }
  }

  double at(int cell) const { return energy_[std::size_t(cell)]; }

  /// The energy of the tightest cluster (of cells with points), or of the largest void.
  double extreme(bool with_points) const {
    double best = with_points ? -1 : 1e9;
    for (std::size_t i = 0; i < cells(); ++i)
      if (has_point_[i] == with_points) best = with_points ? std::max(best, energy_[i]) : std::min(best, energy_[i]);
    return best;
  }

  int tightest_cluster() const {
    int best = -1;
    for (int i = 0; i < int(cells()); ++i)
      if (has_point_[std::size_t(i)] && (best < 0 || at(i) > at(best))) best = i;
    return best;
  }

 private:
  std::size_t cells() const { return std::size_t(size_) * std::size_t(size_); }
  double distance(int a, int b) const { return std::min(std::abs(a - b), size_ - std::abs(a - b)); }

  int size_;
  std::vector<bool> has_point_;
  std::vector<double> energy_;
};

}  // namespace

NoiseCheck check_noise(std::span<const int> ranks, int size, std::span<const int> first) {
  const int cells = size * size, points = int(first.size());
  if (ranks.size() != std::size_t(cells))
    throw Error(fmt::format("blue_noise returned {} ranks for a tile of {} x {}", ranks.size(), size, size));
  NoiseCheck check;
  std::vector<int> cell_of(std::size_t(cells), -1), times(std::size_t(cells), 0);
  for (int cell = 0; cell < cells; ++cell)
    if (const int rank = ranks[std::size_t(cell)]; rank >= 0 && rank < cells) {
      cell_of[std::size_t(rank)] = cell;
      ++times[std::size_t(rank)];
    }
  check.not_once = int(std::ranges::count_if(times, [](int n) { return n != 1; }));
  if (check.not_once > 0) return check;

  Energies pattern(size);
  for (int rank = 0; rank < points; ++rank) {
    pattern.change(cell_of[std::size_t(rank)], true);
    check.points_moved += std::ranges::count(first, cell_of[std::size_t(rank)]) == 0;
  }
  Energies fewer = pattern;
  for (int rank = points - 1; rank >= 0; --rank) {
    const int cell = cell_of[std::size_t(rank)];
    check.taken = std::max(check.taken, fewer.extreme(true) - fewer.at(cell));
    fewer.change(cell, false);
  }
  Energies moved = pattern;
  const int cluster = moved.tightest_cluster();
  moved.change(cluster, false);
  check.relaxed = std::max(0.0, moved.at(cluster) - moved.extreme(false));
  for (int rank = points; rank < cells; ++rank) {
    const int cell = cell_of[std::size_t(rank)];
    check.added = std::max(check.added, pattern.at(cell) - pattern.extreme(false));
    pattern.change(cell, true);
  }
  return check;
}

}  // namespace atelier
