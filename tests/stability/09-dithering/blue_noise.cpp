// blue_noise: tiles of 4 x 4 to 256 x 256, with odd sides too, from one point and from half of the cells.
#include <complex>

#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

using dithering::blue_noise;

namespace {

/// So many different cells by chance: the smallest of random numbers.
std::vector<int> some_cells(int size, int points) {
  std::vector<std::pair<double, int>> order;
  for (int cell = 0; cell < size * size; ++cell) order.emplace_back(Trial(1000, cell).between(0, 1), cell);
  std::ranges::sort(order);
  std::vector<int> cells;
  for (int i = 0; i < points; ++i) cells.push_back(order[std::size_t(i)].second);
  return cells;
}

/// The cell of each rank; empty if a rank is missing.
std::vector<int> cells_by_rank(const std::vector<int>& ranks, int size) {
  std::vector<int> cell_of(std::size_t(size * size), -1);
  if (ranks.size() != cell_of.size()) return {};
  for (std::size_t cell = 0; cell < ranks.size(); ++cell) {
    if (ranks[cell] < 0 || ranks[cell] >= size * size) return {};
    cell_of[std::size_t(ranks[cell])] = int(cell);
  }
  if (std::ranges::count(cell_of, -1) > 0) return {};
  return cell_of;
}

/// The energies of a tile's cells, in double precision and without a limit of distance.
struct TileEnergies {
  int size;
  std::vector<bool> has_point;
  std::vector<double> energy;

  explicit TileEnergies(int side)
      : size(side), has_point(std::size_t(side * side), false), energy(has_point.size(), 0.0) {}

  void set(int cell, bool point) {
    has_point[std::size_t(cell)] = point;
    Values bell;  // by the distance along one side
    for (int d = 0; d < size; ++d) bell.push_back(std::exp(-std::pow(std::min(d, size - d), 2) / 4.5));
    for (int other = 0; other < size * size; ++other) {
      const int dx = std::abs(other % size - cell % size), dy = std::abs(other / size - cell / size);
      energy[std::size_t(other)] += (point ? 1 : -1) * bell[std::size_t(dx)] * bell[std::size_t(dy)];
    }
  }
  double at(int cell) const { return energy[std::size_t(cell)]; }
  double tightest() const { return extreme(true, -1); }
  double emptiest() const { return -extreme(false, 1); }

 private:
  /// The greatest energy of the cells with a point, or of those without one the greatest of -energy.
  double extreme(bool with_point, double sign) const {
    double most = -double(INFINITY);
    for (std::size_t i = 0; i < energy.size(); ++i)
      if (has_point[i] == with_point) most = std::max(most, -sign * energy[i]);
    return most;
  }
};

/// By how much energy the choices that the ranks show miss the right ones, at most: of points taken away, of points
/// added. And by how much the pattern that both start with would still gain by step 1: the least of all its points that
/// may be the tightest cluster. All infinite if a rank is missing.
Values missed_energies(const std::vector<int>& ranks, int size, int points) {
  const std::vector<int> cell_of = cells_by_rank(ranks, size);
  if (cell_of.empty()) return Values(3, double(INFINITY));
  TileEnergies start(size);
  for (int rank = 0; rank < points; ++rank) start.set(cell_of[std::size_t(rank)], true);

  double taken = 0, added = 0, gained = double(INFINITY);
  TileEnergies fewer = start, more = start;
  for (int rank = points - 1; rank >= 0; --rank) {
    const int cell = cell_of[std::size_t(rank)];
    taken = std::max(taken, fewer.tightest() - fewer.at(cell));
    fewer.set(cell, false);
  }
  for (int rank = points; rank < size * size; ++rank) {
    const int cell = cell_of[std::size_t(rank)];
    added = std::max(added, more.at(cell) - more.emptiest());
    more.set(cell, true);
  }
  for (int rank = 0; rank < points; ++rank) {
    const int cell = cell_of[std::size_t(rank)];
    if (start.at(cell) < start.tightest() - 1e-4) continue;
    TileEnergies without = start;
    without.set(cell, false);
    gained = std::min(gained, without.at(cell) - without.emptiest());
  }
  return {taken, added, gained};
}

/// The energy of the ranks below a quarter of the highest frequency, half a cycle a cell, as a part of what white noise
/// has there: its energy is the same at all frequencies but 0.
double low_frequencies(const std::vector<int>& ranks, int size) {
  using Complex = std::complex<double>;
  const auto wave = [=](int k) { return std::polar(1.0, -2 * std::numbers::pi * k / size); };
  std::vector<Complex> of_rows(ranks.size()), spectrum(ranks.size());
  const auto at = [=](int x, int y) { return std::size_t(y * size + x); };
  for (int y = 0; y < size; ++y)
    for (int u = 0; u < size; ++u)
      for (int x = 0; x < size; ++x) of_rows[at(u, y)] += double(ranks[at(x, y)]) * wave(u * x % size);
  for (int v = 0; v < size; ++v)
    for (int u = 0; u < size; ++u)
      for (int y = 0; y < size; ++y) spectrum[at(u, v)] += of_rows[at(u, y)] * wave(v * y % size);
  double low = 0, all = 0, low_count = 0, count = 0;
  for (int v = 0; v < size; ++v)
    for (int u = 0; u < size; ++u) {
      if (u == 0 && v == 0) continue;
      const double energy = std::norm(spectrum[at(u, v)]);
      const bool is_low = std::hypot(std::min(u, size - u), std::min(v, size - v)) < size / 8.0;
      all += energy, count += 1;
      if (is_low) low += energy, low_count += 1;
    }
  return low / all / (low_count / count);
}

void add_noise_refusals(Group& group) {
  for (const int size : {3, 2, 1, 0, -1, -4, 257, 65536, least_int, largest_int})
    group.refuses(fmt::format("size {}", size), [=] { blue_noise(size, std::array{0}); });
  group.refuses("no point", [] { blue_noise(4, {}); });
  group.refuses("9 points of 16 cells", [] { blue_noise(4, some_cells(4, 9)); });
  group.refuses("13 points of 25 cells", [] { blue_noise(5, some_cells(5, 13)); });
  group.refuses("all cells of 16", [] { blue_noise(4, some_cells(4, 16)); });
  group.refuses("32769 points of 65536 cells", [] { blue_noise(256, some_cells(256, 32769)); });
  for (const int cell : {-1, 16, 17, 256, least_int, largest_int})
    group.refuses(fmt::format("4 x 4, cell {}", cell), [=] { blue_noise(4, std::array{5, cell}); });
  group.refuses("4 x 4, a cell twice", [] { blue_noise(4, std::array{3, 7, 3}); });
  group.refuses("4 x 4, a cell 17 times", [] { blue_noise(4, std::vector<int>(17, 3)); });
}

}  // namespace

void add_noise_rows(Table& table) {
  Group group = table.of("blue_noise");
  add_noise_refusals(group);
  for (const int size : {4, 5, 7, 12, 21, 22, 32})
    for (const int points : {1, std::max(2, size * size / 10), size * size / 2}) {
      const auto words = [=](const char* what) {
        return fmt::format("{} x {}, {} points first: {}", size, size, points, what);
      };
      const auto ranks = [=] { return blue_noise(size, some_cells(size, points)); };
      group.equals(words("ranks that are there once"),
                   [=] { return Values{double(cells_by_rank(ranks(), size).size())}; }, {double(size * size)});
      group.close(
          words("energy by which a choice misses the right one"),
          {1e-3, "energies of a point",
           "floats of up to 15 with some hundred roundings, of up to 4e-6 with what marks a point; choices among "
           "almost equal energies are free"},
          [=] {
            const Values missed = missed_energies(ranks(), size, points);
            return *std::ranges::max_element(missed);
          });
    }
  for (const int size : {32, 64})
    for (const int points : {1, size * size / 10, size * size / 2})
      group.close(
          fmt::format("{} x {}, {} points first: energy below a quarter of the highest frequency", size, size, points),
          {0.1, "of white noise's", "blue noise has hardly any low frequencies: that is what it is made for"},
          [=] { return low_frequencies(blue_noise(size, some_cells(size, points)), size); });
  group.equals("256 x 256, 6553 points first: ranks that are there once",
               [] { return Values{double(cells_by_rank(blue_noise(256, some_cells(256, 6553)), 256).size())}; },
               {65536});
}

}  // namespace atelier::stability
