// stroke_centres: pictures and cells of one pixel and of thousands, seeds at both ends, how evenly the pixels of a cell
// are taken, and what the contract refuses.
#include "10-artstyles/given/random.hpp"
#include "stability/10-artstyles/rows.hpp"

namespace atelier::stability {

using artstyles::random_numbers;
using artstyles::stroke_centres;

namespace {

constexpr std::uint32_t last_seed = 0xffffffffu;

Values numbers_of(const std::vector<glm::ivec2>& centres) {
  return all_values(centres);
}

/// The contract in 64-bit numbers, cell by cell.
std::vector<glm::ivec2> exact_centres(glm::ivec2 size, glm::ivec2 cell, std::uint32_t seed) {
  std::vector<glm::ivec2> centres;
  const auto cells = [&](int i) { return (std::int64_t(size[i]) + cell[i] - 1) / cell[i]; };
  for (std::int64_t row = 0; row < cells(1); ++row)
    for (std::int64_t column = 0; column < cells(0); ++column) {
      const glm::uvec2 random(random_numbers(seed, int(column), int(row)));
      const auto place = [&](std::int64_t number, int i) {
        const auto within = std::int64_t(std::floor(double(random[i]) / 0x1p32 * cell[i]));
        return number * cell[i] + within;
      };
      const std::int64_t x = place(column, 0), y = place(row, 1);
      if (x < size.x && y < size.y) centres.emplace_back(int(x), int(y));
    }
  return centres;
}

/// How many centres are outside of the picture, or in the cell of one before.
double misplaced(glm::ivec2 size, glm::ivec2 cell, std::uint32_t seed) {
  double wrong = 0;
  std::int64_t last = -1;
  for (const glm::ivec2& c : stroke_centres(size, cell, seed)) {
    const std::int64_t columns = (std::int64_t(size.x) + cell.x - 1) / cell.x;
    const std::int64_t number = c.y / cell.y * columns + c.x / cell.x;
    wrong += c.x < 0 || c.y < 0 || c.x >= size.x || c.y >= size.y || number <= last;
    last = number;
  }
  return wrong;
}

/// The share of a normal distribution that is farther than z from its mean, on either side.
double share_beyond(double z) {
  return std::erfc(z / std::numbers::sqrt2);
}

/// What the largest |z| of so many tests exceeds with a probability of 1e-3 at most: Sidak's correction, which holds
/// however the tests depend on each other.
double largest_allowed(int tests) {
  const double level = -std::expm1(std::log1p(-1e-3) / tests);
  double low = 0, high = 40;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (share_beyond(middle) > level ? low : high) = middle;
  }
  return high;
}

/// The largest |z| of all pixels of a cell: of how often each is taken by `total` centres, against equal chances.
/// `counts` are of a cell, row by row.
double largest_z(const std::vector<double>& counts) {
  double total = 0, largest = 0;
  for (const double count : counts) total += count;
  const double chance = 1 / double(counts.size()), deviation = std::sqrt(total * chance * (1 - chance));
  for (const double count : counts) largest = worse_of(largest, std::abs(count - total * chance) / deviation);
  return largest;
}

/// Of one cell that is the whole picture, over so many seeds.
double largest_z_of_seeds(glm::ivec2 cell, int seeds) {
  std::vector<double> counts(std::size_t(cell.x * cell.y), 0);
  for (int seed = 0; seed < seeds; ++seed)
    for (const glm::ivec2& c : stroke_centres(cell, cell, std::uint32_t(seed)))
      ++counts.at(std::size_t(c.y * cell.x + c.x));
  return largest_z(counts);
}

/// Of all cells of pictures of 100 x 100 cells, over 8 seeds.
double largest_z_of_cells(glm::ivec2 cell) {
  std::vector<double> counts(std::size_t(cell.x * cell.y), 0);
  for (std::uint32_t seed = 0; seed < 8; ++seed)
    for (const glm::ivec2& c : stroke_centres(100 * cell, cell, last_seed - seed))
      ++counts.at(std::size_t(c.y % cell.y * cell.x + c.x % cell.x));
  return largest_z(counts);
}

void add_even_rows(Group& group) {
  for (const glm::ivec2& cell : {glm::ivec2(2, 1), glm::ivec2(1, 7), glm::ivec2(4, 4), glm::ivec2(10, 9)}) {
    const int pixels = cell.x * cell.y;
    const Bound bound{largest_allowed(pixels), "standard deviations",
                      fmt::format("what the largest of {} exceeds with a probability of 1e-3 at most, by Sidak's "
                                  "correction for so many pixels",
                                  pixels)};
    const std::string words =
        fmt::format("cells of {} x {}: how far the count of a pixel is from an equal share", cell.x, cell.y);
    group.close(words + ", one cell, 40000 seeds", bound, [=] { return largest_z_of_seeds(cell, 40'000); });
    group.close(words + ", 10000 cells, 8 seeds", bound, [=] { return largest_z_of_cells(cell); });
  }
}

void add_refusal_rows(Group& group) {
  for (const int bad : {-1, -1000, least_int}) {
    group.refuses(fmt::format("a picture of {} x 5", bad), [=] { stroke_centres({bad, 5}, {3, 3}, 1); });
    group.refuses(fmt::format("a picture of 5 x {}", bad), [=] { stroke_centres({5, bad}, {3, 3}, 1); });
    group.refuses(fmt::format("a picture of {} x 0", bad), [=] { stroke_centres({bad, 0}, {3, 3}, 1); });
  }
  for (const int bad : {0, -1, least_int}) {
    group.refuses(fmt::format("cells of {} x 3", bad), [=] { stroke_centres({5, 5}, {bad, 3}, 1); });
    group.refuses(fmt::format("cells of 3 x {}", bad), [=] { stroke_centres({5, 5}, {3, bad}, 1); });
    group.refuses(fmt::format("no pixels, cells of {} x 3", bad), [=] { stroke_centres({0, 0}, {bad, 3}, 1); });
  }
}

}  // namespace

void add_centres_rows(Table& table) {
  Group group = table.of("stroke_centres");
  for (const std::uint32_t seed : {0u, 1u, last_seed})
    for (const glm::ivec2& size :
         {glm::ivec2(1, 1), glm::ivec2(1, 5000), glm::ivec2(5000, 1), glm::ivec2(301, 199), glm::ivec2(16384, 16384)})
      for (const glm::ivec2& cell : {glm::ivec2(1, 1), glm::ivec2(7, 3), glm::ivec2(1, 10'000),
                                     glm::ivec2(10'000, 10'000), glm::ivec2(largest_int, largest_int)}) {
        if (std::int64_t(size.x) * size.y / cell.x / cell.y > 100'000) continue;
        const std::string words =
            fmt::format("{} x {}, cells of {} x {}, a seed of {}", size.x, size.y, cell.x, cell.y, seed);
        group.same(
            words, [=] { return numbers_of(stroke_centres(size, cell, seed)); },
            [=] { return numbers_of(exact_centres(size, cell, seed)); });
        group.equals(words + ": centres outside, or two in a cell", [=] { return Values{misplaced(size, cell, seed)}; },
                     {0});
      }
  group.equals("cells of one pixel: every pixel once, row by row",
               [] {
                 const std::vector<glm::ivec2> centres = stroke_centres({200, 150}, {1, 1}, 5);
                 double wrong = std::abs(double(centres.size()) - 200 * 150);
                 for (std::size_t i = 0; i < centres.size(); ++i)
                   wrong += centres[i] != glm::ivec2(int(i) % 200, int(i) / 200);
                 return Values{wrong};
               },
               {0});
  group.equals("no pixels: no centres",
               [] {
                 Values counts;
                 for (const glm::ivec2& size : {glm::ivec2(0, 0), glm::ivec2(0, 5000), glm::ivec2(5000, 0)})
                   counts.push_back(double(stroke_centres(size, {3, 4}, 9).size()));
                 return counts;
               },
               {0, 0, 0});
  add_even_rows(group);
  add_refusal_rows(group);
}

}  // namespace atelier::stability
