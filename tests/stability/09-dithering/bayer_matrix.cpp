// bayer_matrix: all four sizes, and each int that is near them, huge or negative.
#include <stdexcept>

#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

using dithering::bayer_matrix;

namespace {

Values bayer_ranks(int size) {
  const std::vector<int> matrix = bayer_matrix(size);
  return Values(matrix.begin(), matrix.end());
}

/// By the bits of row and column: the least significant ones have the greatest weight in the rank. In each pair of bits
/// the first says whether those of row and column differ, the second is that of the row.
Values exact_bayer_ranks(int size) {
  Values ranks;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      int rank = 0;
      for (int bit = 1; bit < size; bit *= 2) {
        const int down = (row & bit) != 0, right = (column & bit) != 0;
        rank = 4 * rank + 2 * (down ^ right) + down;
      }
      ranks.push_back(rank);
    }
  return ranks;
}

/// How many ranks of 0 .. size^2 - 1 are not there exactly once.
double ranks_not_once(int size) {
  std::vector<int> times(std::size_t(size * size), 0);
  for (const int rank : bayer_matrix(size)) ++times.at(std::size_t(rank));
  return double(std::count_if(times.begin(), times.end(), [](int n) { return n != 1; }));
}

/// How many ranks of a quarter (0: left, 1: right; 0: upper, 1: lower) are not 4 times that of the smaller matrix plus
/// `offset`.
double wrong_in_quarter(int size, int right, int lower, int offset) {
  const int half = size / 2;
  const std::vector<int> matrix = bayer_matrix(size), smaller = half == 1 ? std::vector<int>{0} : bayer_matrix(half);
  double wrong = 0;
  for (int y = 0; y < half; ++y)
    for (int x = 0; x < half; ++x) {
      const int rank = matrix.at(std::size_t((y + lower * half) * size + x + right * half));
      wrong += rank != 4 * smaller.at(std::size_t(y * half + x)) + offset;
    }
  return wrong;
}

/// By how many points two quarters differ, at most, of the points whose rank is below any number.
double unevenness(int size) {
  const std::vector<int> matrix = bayer_matrix(size);
  std::vector<int> quarter_of(matrix.size());
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      quarter_of.at(std::size_t(matrix.at(std::size_t(y * size + x)))) = 2 * (2 * y / size) + 2 * x / size;
  std::array<int, 4> points{};
  int worst = 0;
  for (const int quarter : quarter_of) {
    ++points.at(std::size_t(quarter));
    worst = std::max(worst, *std::ranges::max_element(points) - *std::ranges::min_element(points));
  }
  return worst;
}

/// How many ints from `low` to `high` that are no size of the contract are not refused.
double accepted_between(int low, int high) {
  double accepted = 0;
  for (int size = low; size <= high; ++size) {
    if (size == 2 || size == 4 || size == 8 || size == 16) continue;
    try {
      bayer_matrix(size);
      ++accepted;
    } catch (const std::invalid_argument&) {
    }
  }
  return accepted;
}

}  // namespace

void add_bayer_rows(Table& table) {
  Group group = table.of("bayer_matrix");
  group.equals("size 2", [] { return bayer_ranks(2); }, {0, 2, 3, 1});
  group.equals("size 8: the first two rows, as printed in books",
               [] {
                 Values ranks = bayer_ranks(8);
                 ranks.resize(16);
                 return ranks;
               },
               {0, 32, 8, 40, 2, 34, 10, 42, 48, 16, 56, 24, 50, 18, 58, 26});
  for (const int size : {2, 4, 8, 16}) {
    const auto words = [=](const char* what) { return fmt::format("size {}: {}", size, what); };
    group.equals(
        words("all ranks, by the bits of row and column"), [=] { return bayer_ranks(size); }, exact_bayer_ranks(size));
    group.equals(words("ranks that are not there once"), [=] { return Values{ranks_not_once(size)}; }, {0});
    group.equals(words("wrong ranks in the quarters upper left, upper right, lower left, lower right"),
                 [=] {
                   return Values{wrong_in_quarter(size, 0, 0, 0), wrong_in_quarter(size, 1, 0, 2),
                                 wrong_in_quarter(size, 0, 1, 3), wrong_in_quarter(size, 1, 1, 1)};
                 },
                 {0, 0, 0, 0});
    group.equals(words("points that a quarter has more than another, below any rank"),
                 [=] { return Values{unevenness(size)}; }, {1});
  }
  group.equals("every other int from -300 to 300 that is not refused",
               [] { return Values{accepted_between(-300, 300)}; }, {0});
  for (const int bad : {0, 1, 3, 15, 17, 32, 64, 256, 65536, 1 << 30, largest_int, -1, -2, -16, -65536, least_int})
    group.refuses(fmt::format("size {}", bad), [=] { bayer_matrix(bad); });
}

}  // namespace atelier::stability
