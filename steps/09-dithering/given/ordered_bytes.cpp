#include "09-dithering/given/ordered_bytes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

namespace atelier {

namespace {

/// Sixteen bytes, four pixels, at a time: with these vectors GCC and Clang use one instruction for all of them.
using Bytes = std::uint8_t __attribute__((vector_size(16)));

/// The least code, at a cell's threshold, that becomes this level or a higher one: the least with
/// code / 255 * (levels - 1) + 1 - (rank + 1/2) / count >= level.
std::uint8_t least_code(int level, int rank, int count, int levels) {
  const std::int64_t wanted = std::int64_t(255) * (2 * std::int64_t(count) * (level - 1) + 2 * rank + 1);
  const std::int64_t a_code = 2 * std::int64_t(count) * (levels - 1);
  return std::uint8_t((wanted + a_code - 1) / a_code);
}

int code_of(int level, int levels) {
  return (510 * level + levels - 1) / (2 * (levels - 1));
}

/// A row of the pattern for four pixels after one another: from which code on each level begins, and by how much the
/// result grows there. Opacities keep what they are.
struct Step {
  std::vector<Bytes> begins;  ///< periodic
  std::uint8_t growth = 0;
};

std::vector<Step> steps_of(std::span<const int> ranks, int side, int levels) {
  std::vector<Step> steps;
  const std::size_t period = std::size_t(std::max(side, 4)) / 4;
  for (int level = 1; level < levels; ++level) {
    Step step{.begins = std::vector<Bytes>(period),
              .growth = std::uint8_t(code_of(level, levels) - code_of(level - 1, levels))};
    for (std::size_t byte = 0; byte < 16 * period; ++byte)
      step.begins[byte / 16][byte % 16] = least_code(level, ranks[byte / 4 % std::size_t(side)], side * side, levels);
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace

void dither_bytes(std::span<std::uint8_t> rgba, int width, std::span<const int> ranks, int side, int levels) {
  std::vector<std::vector<Step>> rows;
  for (int y = 0; y < side; ++y)
    rows.push_back(steps_of(ranks.subspan(std::size_t(y * side), std::size_t(side)), side, levels));
  Bytes opacities;
  for (int i = 0; i < 16; ++i) opacities[i] = i % 4 == 3 ? 255 : 0;

  const std::size_t row_bytes = 4 * std::size_t(width), period = 16 * rows[0][0].begins.size();
  const auto dither = [&](std::uint8_t* pixels, std::size_t bytes, const std::vector<Step>& steps, std::size_t phase) {
    Bytes codes{}, result{};
    std::memcpy(&codes, pixels, bytes);
    for (const Step& step : steps) result += Bytes(codes >= step.begins[phase]) & step.growth;
    result = (result & ~opacities) | (codes & opacities);
    std::memcpy(pixels, &result, bytes);
  };
  for (std::size_t y = 0; y * row_bytes < rgba.size(); ++y) {
    const std::vector<Step>& steps = rows[y % std::size_t(side)];
    std::uint8_t* const row = &rgba[y * row_bytes];
    // Blocks of pixels with the same part of the pattern after one another.
    for (std::size_t phase = 0; 16 * phase < period; ++phase) {
      std::size_t at = 16 * phase;
      for (; at + 16 <= row_bytes; at += period) dither(row + at, 16, steps, phase);
      if (at < row_bytes) dither(row + at, row_bytes - at, steps, phase);
    }
  }
}

}  // namespace atelier
