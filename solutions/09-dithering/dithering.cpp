#include "09-dithering/dithering.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace atelier::dithering {

// >>> student: what your functions below share, if anything
namespace {

void check_picture(std::size_t pixels, int width, int levels) {
  if (levels < 2 || levels > 256) throw std::invalid_argument("levels must be 2 to 256");
  if (width < 1 || pixels % std::size_t(width) != 0) throw std::invalid_argument("rows must be full");
}

/// The shares that stay inside the picture from a pixel of column `x`, in a row that is the last one or not.
std::vector<Share> shares_inside(std::vector<Share> shares, int x, int width, int rows_below) {
  float all = 0, inside = 0;
  for (const Share& share : shares) all += share.part;
  std::erase_if(shares, [&](const Share& s) {
    return x + s.right < 0 || x + s.right >= width || s.down > rows_below;
  });
  for (const Share& share : shares) inside += share.part;
  for (Share& share : shares) share.part *= all / inside;
  return shares;
}

/// The pattern of void and cluster: each cell's energy, to which a cell with a point adds so much that none without a
/// point comes near it. So the largest void has the least of these numbers, and the tightest cluster the greatest. The
/// extremes of each row are kept, because a point changes few rows.
class Pattern {
 public:
  Pattern(int size, std::span<const int> points)
      : size_(size), energy_(std::size_t(size) * std::size_t(size), 0.0f), least_(std::size_t(size)), most_(least_) {
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const double dx = std::min(x, size - x), dy = std::min(y, size - y), squared = dx * dx + dy * dy;
        bell_.push_back(squared <= reach * reach ? float(std::exp(-squared / (2 * 1.5 * 1.5))) : 0);
      }
    bell_[0] += point;
    for (int y = 0; y < size; ++y) find_extremes(y);
    for (const int cell : points) change(cell, 1);
  }
  void add(int cell) { change(cell, 1); }
  void remove(int cell) { change(cell, -1); }
  int tightest_cluster() const { return cell_with(most_, std::ranges::max_element(most_)); }
  int largest_void() const { return cell_with(least_, std::ranges::min_element(least_)); }
  float energy(int cell) const { return energy_[std::size_t(cell)]; }

 private:
  static constexpr float point = 64;  // all points together give a cell less than 15
  static constexpr int reach = 10;    // exp(-10^2 / 4.5) is 2e-10, which a float near 15 does not notice

  void change(int cell, float sign) {
    const int left = cell % size_, top = cell / size_, all = std::min(size_, 2 * reach + 1);
    for (int i = 0; i < all; ++i) {
      const int down = (i + size_ - all / 2) % size_, y = (top + down) % size_;
      const float* bell = &bell_[std::size_t(down) * std::size_t(size_)];
      float* row = &energy_[std::size_t(y) * std::size_t(size_)];
      for (int x = 0; x < left; ++x) row[x] += sign * bell[x - left + size_];
      for (int x = left; x < size_; ++x) row[x] += sign * bell[x - left];
      find_extremes(y);
    }
  }

  void find_extremes(int y) {
    float least = energy(y * size_), most = least;
    for (int cell = y * size_; cell < (y + 1) * size_; ++cell) {
      least = std::min(least, energy(cell));
      most = std::max(most, energy(cell));
    }
    least_[std::size_t(y)] = least;
    most_[std::size_t(y)] = most;
  }

  /// The cell with an extreme, of the extremes of all rows.
  int cell_with(const std::vector<float>& of_rows, std::vector<float>::const_iterator extreme) const {
    const auto row = energy_.begin() + (extreme - of_rows.begin()) * size_;
    return int(std::find(row, row + size_, *extreme) - energy_.begin());
  }

  int size_;
  std::vector<float> bell_;  ///< what a point in cell 0 gives to each cell
  std::vector<float> energy_;
  std::vector<float> least_, most_;  ///< of the energies in each row
};

/// Four channels at a time: with these vectors GCC and Clang use one instruction for all of them.
using Four = float __attribute__((vector_size(16)));
using FourWhole = std::int32_t __attribute__((vector_size(16)));
using EightWhole = std::int16_t __attribute__((vector_size(16)));
using Bytes = std::uint8_t __attribute__((vector_size(16)));

/// Sixteen codes as values from 0 to `last`, by the same steps as for a single one.
void widen(const std::uint8_t* from, float last, Four* to) {
  Bytes bytes;
  std::memcpy(&bytes, from, sizeof bytes);
  const Bytes none{};
  const auto low =
      EightWhole(__builtin_shufflevector(bytes, none, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23));
  const auto high =
      EightWhole(__builtin_shufflevector(bytes, none, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31));
  const EightWhole zero{};
  const auto value = [&](const EightWhole& whole) {
    return __builtin_convertvector(FourWhole(whole), Four) * (1.0f / 255) * last;
  };
  to[0] = value(__builtin_shufflevector(low, zero, 0, 8, 1, 9, 2, 10, 3, 11));
  to[1] = value(__builtin_shufflevector(low, zero, 4, 12, 5, 13, 6, 14, 7, 15));
  to[2] = value(__builtin_shufflevector(high, zero, 0, 8, 1, 9, 2, 10, 3, 11));
  to[3] = value(__builtin_shufflevector(high, zero, 4, 12, 5, 13, 6, 14, 7, 15));
}

/// Sixteen numbers, each 0..255, as bytes.
void narrow(const FourWhole* from, std::uint8_t* to) {
  const auto pair = [](const FourWhole& a, const FourWhole& b) {
    return __builtin_shufflevector(EightWhole(a), EightWhole(b), 0, 2, 4, 6, 8, 10, 12, 14);
  };
  const EightWhole low = pair(from[0], from[1]), high = pair(from[2], from[3]);
  const Bytes bytes =
      __builtin_shufflevector(Bytes(low), Bytes(high), 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
  std::memcpy(to, &bytes, sizeof bytes);
}

/// Floyd and Steinberg's shares of a pixel.
struct Parts {
  float right = 0, below_left = 0, below = 0, below_right = 0;
};

Parts parts_at(int x, int width, int rows_below) {
  Parts parts;
  for (const Share& s : shares_inside(shares_of(Kernel::floyd_steinberg), x, width, rows_below))
    (s.down == 0 ? parts.right : s.right < 0 ? parts.below_left : s.right == 0 ? parts.below : parts.below_right) =
        s.part;
  return parts;
}

/// Diffuses errors in bands of eight rows. In a row each pixel waits for the one before it, so a processor that could
/// do much more at a time is idle. The rows of a band take turns: each is two pixels behind the one above it, which by
/// then has passed all errors on that the pixel needs.
class Bands {
 public:
  static constexpr int rows = 8;

  Bands(std::span<const std::uint8_t> codes, int width, int levels, std::span<std::uint8_t> chosen)
      : codes_(codes),
        chosen_(chosen),
        width_(width),
        height_(int(codes.size()) / 4 / width),
        last_(float(levels - 1)) {
    for (auto& row : values_) row.assign(std::size_t(width) + 2 * margin, Four{});
    for (auto& row : levels_) row.assign(std::size_t(width), FourWhole{});
  }

  void diffuse() {
    read_values(0, values_[0]);
    for (int top = 0; top < height_; top += rows) diffuse_band(top);
  }

 private:
  static constexpr int behind = 2 * (rows - 1);  ///< pixels by which the last row is behind the first
  static constexpr int margin = behind + 4;      ///< pixels of 0 on both sides of a row

  /// By row of the band.
  struct State {
    Four sum[rows] = {};  ///< of the next pixel: its value and all errors that it has received
    Four one[rows] = {}, two[rows] = {};  ///< of pixels in the row below, with the errors of one and of two pixels
  };
  using BandParts = std::array<std::array<Parts, 3>, rows>;  ///< in the first column, between, in the last column

  /// 0 for a row below the picture.
  void read_values(int row, std::vector<Four>& values) const {
    Four* const to = values.data() + margin;
    if (row >= height_) return void(std::fill_n(to, width_, Four{}));
    const std::uint8_t* const from = &codes_[4 * std::size_t(row) * std::size_t(width_)];
    int x = 0;
    for (; x + 4 <= width_; x += 4) widen(from + 4 * x, last_, to + x);
    for (; x < width_; ++x)
      for (int channel = 0; channel < 4; ++channel)
        to[x][channel] = float(from[4 * x + channel]) * (1.0f / 255) * last_;
  }

  void write_levels(int row, const std::vector<FourWhole>& levels) const {
    std::uint8_t* const to = &chosen_[4 * std::size_t(row) * std::size_t(width_)];
    int x = 0;
    for (; x + 4 <= width_; x += 4) narrow(&levels[std::size_t(x)], to + 4 * x);
    for (; x < width_; ++x)
      for (int channel = 0; channel < 4; ++channel) to[4 * x + channel] = std::uint8_t(levels[std::size_t(x)][channel]);
  }

  /// values_[0] has the first row with the errors from above, and then those of the row after the band.
  void diffuse_band(int top) {
    BandParts parts;
    for (int row = 0; row < rows; ++row) {
      const int below = height_ - 1 - top - row;
      parts[std::size_t(row)] = {parts_at(0, width_, below), parts_at(std::min(1, width_ - 1), width_, below),
                                 parts_at(width_ - 1, width_, below)};
      read_values(top + row + 1, values_[std::size_t(row) + 1]);
    }
    State state;
    const int end = width_ + behind + 1;
    int column = -1;  // of the first row
    for (; column < std::min(behind + 2, end); ++column) advance<false>(column, parts, state);
    if (top + rows < height_)
      for (; column < width_ - 1; ++column) advance<true>(column, parts, state);
    for (; column < end; ++column) advance<false>(column, parts, state);
    for (int row = 0; row < std::min(rows, height_ - top); ++row) write_levels(top + row, levels_[std::size_t(row)]);
  }

  /// One pixel in each row, in the first row that of this column. `Inside`: all have neighbours on all sides.
  template <bool Inside>
  void advance(int column, const BandParts& parts, State& state) {
    Four arriving = values_[0][std::size_t(column + 1 + margin)];  // what the row above has made of the next pixel
#pragma GCC unroll 8
    for (int row = 0; row < rows; ++row) {
      const int x = column - 2 * row;
      const Parts part = Inside ? Parts{7 / 16.0f, 3 / 16.0f, 5 / 16.0f, 1 / 16.0f}
                                : parts[std::size_t(row)][x <= 0 ? 0 : x + 1 < width_ ? 1 : 2];
      Four error = {};
      if (Inside || (x >= 0 && x < width_))
        error = take_level(levels_[std::size_t(row)][std::size_t(x)], state.sum[row]);
      state.sum[row] = arriving + error * part.right;
      arriving = state.two[row] + error * part.below_left;
      state.two[row] = state.one[row] + error * part.below;
      state.one[row] = values_[std::size_t(row) + 1][std::size_t(x + 1 + margin)] + error * part.below_right;
    }
    const int below = column - 2 * rows + 1;  // the pixel after the band that has all its errors now
    if (Inside || (below >= 0 && below < width_)) values_[0][std::size_t(below + margin)] = arriving;
  }

  /// Sets the level of a sum and returns its error.
  Four take_level(FourWhole& level, const Four& sum) const {
    Four nearest = sum + 0.5f;
    nearest = nearest > 0.0f ? nearest : Four{};
    nearest = nearest < last_ ? nearest : Four{} + last_;
    level = __builtin_convertvector(nearest, FourWhole);
    return sum - __builtin_convertvector(level, Four);
  }

  std::span<const std::uint8_t> codes_;
  std::span<std::uint8_t> chosen_;
  int width_, height_;
  float last_;  ///< level
  std::array<std::vector<Four>, rows + 1> values_;
  std::array<std::vector<FourWhole>, rows> levels_;
};

/// Appends a number with its least significant byte first.
[[maybe_unused]] void append(std::vector<std::uint8_t>& file, std::uint32_t number, int bytes) {
  for (int i = 0; i < bytes; ++i) file.push_back(std::uint8_t(number >> (8 * i)));
}

}  // namespace
// --- skeleton
// <<< student

std::vector<int> bayer_matrix(int size) {
  // >>> student: four of the smaller ones
  if (size != 2 && size != 4 && size != 8 && size != 16) throw std::invalid_argument("size must be 2, 4, 8 or 16");
  std::vector<int> matrix{0};
  for (int half = 1; half < size; half *= 2) {
    std::vector<int> larger(std::size_t(4 * half * half));
    for (int y = 0; y < 2 * half; ++y)
      for (int x = 0; x < 2 * half; ++x) {
        const bool lower = y >= half, right = x >= half;
        const int quarter = lower ? (right ? 1 : 3) : (right ? 2 : 0);
        larger[std::size_t(y * 2 * half + x)] = 4 * matrix[std::size_t(y % half * half + x % half)] + quarter;
      }
    matrix = larger;
  }
  return matrix;
  // --- skeleton
  // | return std::vector<int>(std::size_t(size) * std::size_t(size), 0);
  // <<< student
}

std::vector<Share> shares_of(Kernel kernel) {
  // >>> student: who gets how much?
  if (kernel == Kernel::atkinson)
    return {{1, 0, 1 / 8.0f}, {2, 0, 1 / 8.0f},  {-1, 1, 1 / 8.0f},
            {0, 1, 1 / 8.0f}, {1, 1, 1 / 8.0f}, {0, 2, 1 / 8.0f}};
  return {{1, 0, 7 / 16.0f}, {-1, 1, 3 / 16.0f}, {0, 1, 5 / 16.0f}, {1, 1, 1 / 16.0f}};
  // --- skeleton
  // | static_cast<void>(kernel);
  // | return {};
  // <<< student
}

std::vector<std::uint8_t> diffused(std::span<const float> values, int width, const Diffusion& how) {
  // >>> student: level, error, neighbours
  check_picture(values.size(), width, how.levels);
  const std::vector<Share> shares = shares_of(how.kernel);
  const int height = int(values.size()) / width;
  const float last = float(how.levels - 1);
  std::vector<float> sums;  // in levels
  sums.reserve(values.size());
  for (const float value : values) sums.push_back(value > 0 ? std::min(value, 1.0f) * last : 0.0f);  // not a number: 0
  std::vector<std::uint8_t> levels(values.size());
  for (int y = 0; y < height; ++y) {
    const bool backwards = how.serpentine && y % 2 == 1;
    for (int i = 0; i < width; ++i) {
      const int x = backwards ? width - 1 - i : i;
      float* const sum = &sums[std::size_t(y) * std::size_t(width) + std::size_t(x)];
      const int level = int(std::clamp(*sum + 0.5f, 0.0f, last));
      levels[std::size_t(sum - sums.data())] = std::uint8_t(level);
      const float error = *sum - float(level);
      const auto give = [&](const Share& share) {
        sum[share.down * width + (backwards ? -share.right : share.right)] += error * share.part;
      };
      if (i >= 2 && i + 2 < width && y + 2 < height)
        std::ranges::for_each(shares, give);
      else
        std::ranges::for_each(shares_inside(shares, i, width, height - 1 - y), give);
    }
  }
  return levels;
  // --- skeleton
  // | static_cast<void>(width);
  // | static_cast<void>(how);
  // | return std::vector<std::uint8_t>(values.size(), 0);
  // <<< student
}

std::vector<int> blue_noise(int size, std::span<const int> first) {
  // >>> student: relax, take away, add
  if (size < 4 || size > 256) throw std::invalid_argument("size must be 4 to 256");
  const int cells = size * size;
  std::vector<int> sorted(first.begin(), first.end());
  std::ranges::sort(sorted);
  if (sorted.empty() || 2 * int(sorted.size()) > cells || sorted.front() < 0 || sorted.back() >= cells ||
      std::ranges::adjacent_find(sorted) != sorted.end())
    throw std::invalid_argument("different cells for at most half of them are wanted");
  Pattern pattern(size, first);
  while (true) {
    const int cluster = pattern.tightest_cluster();
    pattern.remove(cluster);
    const int largest = pattern.largest_void();
    const bool better = pattern.energy(largest) < pattern.energy(cluster) - 1e-4f;
    pattern.add(better ? largest : cluster);
    if (!better) break;
  }
  std::vector<int> ranks(std::size_t(cells), 0);
  Pattern fewer = pattern;
  for (int rank = int(first.size()) - 1; rank >= 0; --rank) {
    const int cell = fewer.tightest_cluster();
    ranks[std::size_t(cell)] = rank;
    fewer.remove(cell);
  }
  for (int rank = int(first.size()); rank < cells; ++rank) {
    const int cell = pattern.largest_void();
    ranks[std::size_t(cell)] = rank;
    pattern.add(cell);
  }
  return ranks;
  // --- skeleton
  // | static_cast<void>(first);
  // | return std::vector<int>(std::size_t(size) * std::size_t(size), 0);
  // <<< student
}

std::vector<std::uint8_t> bitmap_file(std::span<const std::uint8_t> bits, int width) {
  // >>> student: two headers, two colours, rows
  if (width < 1 || bits.empty() || bits.size() % std::size_t(width) != 0)
    throw std::invalid_argument("a picture of full rows is wanted");
  const auto columns = std::uint32_t(width), rows = std::uint32_t(bits.size() / std::size_t(width));
  const std::uint32_t row_bytes = (columns + 31) / 32 * 4, colours_at = 14 + 40, pixels_at = colours_at + 2 * 4;
  std::vector<std::uint8_t> file = {'B', 'M'};
  append(file, pixels_at + rows * row_bytes, 4);
  append(file, 0, 4);  // reserved
  append(file, pixels_at, 4);
  append(file, 40, 4);  // of the second header
  append(file, columns, 4);
  append(file, rows, 4);
  append(file, 1, 2);  // plane
  append(file, 1, 2);  // bit a pixel
  append(file, 0, 4);  // no compression
  append(file, rows * row_bytes, 4);
  append(file, 2835, 4);  // pixels a metre: 72 an inch
  append(file, 2835, 4);
  append(file, 2, 4);  // colours
  append(file, 2, 4);  // of which all are needed
  append(file, 0x000000, 4);
  append(file, 0xffffff, 4);
  file.resize(pixels_at + std::size_t(rows) * row_bytes, 0);
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x)
      if (bits[std::size_t(y) * columns + x] != 0)
        file[pixels_at + std::size_t(rows - 1 - y) * row_bytes + x / 8] |= std::uint8_t(0x80 >> (x % 8));
  return file;
  // --- skeleton
  // | static_cast<void>(bits);
  // | static_cast<void>(width);
  // | return {};
  // <<< student
}

std::vector<std::uint8_t> diffused_fast(std::span<const std::uint8_t> codes, int width, int levels) {
  // >>> student: several rows at once
  if (width < 1 || codes.size() % (4 * std::size_t(width)) != 0) throw std::invalid_argument("rows must be full");
  check_picture(codes.size() / 4, width, levels);
  std::vector<std::uint8_t> chosen(codes.size());
  if (!codes.empty()) Bands(codes, width, levels, chosen).diffuse();
  return chosen;
  // --- skeleton
  // | static_cast<void>(width);
  // | static_cast<void>(levels);
  // | return std::vector<std::uint8_t>(codes.size(), 0);
  // <<< student
}

}  // namespace atelier::dithering
