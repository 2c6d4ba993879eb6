#include "stability/09-dithering/diffusions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace atelier::stability {

using dithering::Diffusion;
using dithering::Kernel;

namespace {

struct ExactShare {
  int right, down;
  double parts;
};

/// In sixteenths.
const std::vector<ExactShare>& exact_shares(Kernel kernel) {
  static const std::vector<ExactShare> floyd_steinberg = {{1, 0, 7}, {-1, 1, 3}, {0, 1, 5}, {1, 1, 1}};
  static const std::vector<ExactShare> atkinson = {{1, 0, 2}, {2, 0, 2}, {-1, 1, 2}, {0, 1, 2}, {1, 1, 2}, {0, 2, 2}};
  return kernel == Kernel::atkinson ? atkinson : floyd_steinberg;
}

/// Sums of a picture, in levels, to which errors are added.
struct Sums {
  int width, height;
  std::vector<double> of_pixel;

  bool contains(int x, int y) const { return x >= 0 && x < width && y < height; }
  double& at(int x, int y) { return of_pixel[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }

  /// `turn` is -1 where the row runs backwards.
  void spread(double error, int x, int y, int turn, const std::vector<ExactShare>& shares) {
    double all = 0, inside = 0;
    for (const ExactShare& share : shares) {
      all += share.parts / 16;
      if (contains(x + turn * share.right, y + share.down)) inside += share.parts;
    }
    for (const ExactShare& share : shares)
      if (contains(x + turn * share.right, y + share.down))
        at(x + turn * share.right, y + share.down) += error * all * (share.parts / inside);
  }
};

}  // namespace

Grey flat_picture(int width, int height, float value) {
  return {width, height, std::vector<float>(std::size_t(width) * std::size_t(height), value)};
}

Grey noise_picture(int width, int height, std::uint64_t seed) {
  Grey picture{width, height, {}};
  Trial t(seed, 0);
  for (int i = 0; i < width * height; ++i) picture.values.push_back(float(t.between(0, 1)));
  return picture;
}

Grey slope_picture(int width, int height, std::uint64_t seed) {
  Grey picture{width, height, {}};
  Trial t(seed, 1);
  const double across = t.between(0, 239), down = 239 - across;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double code = across * x / width + down * y / height + t.between(0, 16);
      picture.values.push_back(float(std::floor(code)) * (1.0f / 255));
    }
  return picture;
}

Grey mirrored(const Grey& picture) {
  Grey out = picture;
  for (auto row = out.values.begin(); row != out.values.end(); row += out.width) std::reverse(row, row + out.width);
  return out;
}

std::vector<std::uint8_t> levels_of(const Grey& picture, const Diffusion& how) {
  return dithering::diffused(picture.values, picture.width, how);
}

Values level_numbers(const Grey& picture, const Diffusion& how) {
  const std::vector<std::uint8_t> levels = levels_of(picture, how);
  return Values(levels.begin(), levels.end());
}

double level_missed_by(const Grey& picture, const Diffusion& how, const std::vector<std::uint8_t>& levels) {
  constexpr double broken = std::numeric_limits<double>::infinity();
  if (levels.size() != picture.values.size()) return broken;
  const double last = how.levels - 1;
  Sums sums{picture.width, picture.height, {}};
  for (const float value : picture.values)
    sums.of_pixel.push_back(value > 0 ? std::min(double(value), 1.0) * last : 0);  // also of NaN
  double worst = 0;
  for (int y = 0; y < picture.height; ++y) {
    const int turn = how.serpentine && y % 2 == 1 ? -1 : 1;
    for (int i = 0; i < picture.width; ++i) {
      const int x = turn > 0 ? i : picture.width - 1 - i;
      const double level = levels[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)], sum = sums.at(x, y);
      if (level > last) return broken;
      worst = std::max(worst, std::abs(level - std::clamp(sum, 0.0, last)) - 0.5);
      sums.spread(sum - level, x, y, turn, exact_shares(how.kernel));
    }
  }
  return worst;
}

}  // namespace atelier::stability
