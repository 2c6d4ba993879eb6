#include "09-dithering/given/exact_diffusion.hpp"

#include <algorithm>
#include <cmath>

namespace atelier {

std::vector<int> exactly_diffused(const std::vector<double>& values, int width, int levels, bool atkinson,
                                  bool serpentine) {
  struct Part {
    int right, down;
    double part;
  };
  const std::vector<Part> parts =
      atkinson ? std::vector<Part>{{1, 0, 2}, {2, 0, 2}, {-1, 1, 2}, {0, 1, 2}, {1, 1, 2}, {0, 2, 2}}
               : std::vector<Part>{{1, 0, 7}, {-1, 1, 3}, {0, 1, 5}, {1, 1, 1}};
  const int height = int(values.size()) / width;
  std::vector<double> errors(values.size(), 0);
  std::vector<int> chosen(values.size(), 0);
  const auto turned = [&](int y) { return serpentine && y % 2 == 1 ? -1 : 1; };
  // What the pixel (x, y) gets of the one from which it is `part` away.
  const auto share = [&](int x, int y, const Part& part) {
    const int v = y - part.down, u = x - turned(v) * part.right;
    if (v < 0 || u < 0 || u >= width) return 0.0;
    double all = 0, inside = 0;
    for (const Part& other : parts) {
      const int to = u + turned(v) * other.right;
      all += other.part;
      if (to >= 0 && to < width && v + other.down < height) inside += other.part;
    }
    return errors[std::size_t(v * width + u)] * part.part * all / inside / 16;
  };
  for (int y = 0; y < height; ++y)
    for (int i = 0; i < width; ++i) {
      const int x = turned(y) > 0 ? i : width - 1 - i;
      double sum = 255 * std::clamp(values[std::size_t(y * width + x)], 0.0, 1.0);
      for (const Part& part : parts) sum += share(x, y, part);
      const int level = std::clamp(int(std::floor(sum / 255 * (levels - 1) + 0.5)), 0, levels - 1);
      chosen[std::size_t(y * width + x)] = level;
      errors[std::size_t(y * width + x)] = sum - 255.0 * level / (levels - 1);
    }
  return chosen;
}

}  // namespace atelier
