// level_of: 0, 1, all codes of 8 bits and values beyond, at thresholds from nearly 0 to nearly 1 and 2 to 256 levels.
#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

using dithering::bayer_matrix;

namespace {

/// Of rank 0 in the tile of blue noise that the program uses, 64 x 64: the lowest of all that it has.
constexpr float lowest_threshold = 0.5f / 4096;

/// A call: (value, threshold, levels).
ShaderInput level_call(double value, double threshold, int levels) {
  return input_of(glm::vec3(value, threshold, levels));
}

double middle_of_rank(int rank, int count) {
  return (rank + 0.5) / count;
}

/// By how much a level is not the one below or at its value on the scale of levels plus what the threshold adds.
double level_error(const ShaderInput& in, double level) {
  const double value = std::clamp(double(in[0].x), 0.0, 1.0);
  const double place = value * (double(in[0].z) - 1) + 1 - double(in[0].y);
  return std::max({level - place, place - 1 - level, 0.0});
}

/// Calls for all level counts, at all thresholds of a matrix of 16 x 16.
std::vector<ShaderInput> at_all_levels(double value) {
  std::vector<ShaderInput> calls;
  for (int levels = 2; levels <= 256; ++levels)
    for (int rank = 0; rank < 256; ++rank) calls.push_back(level_call(value, middle_of_rank(rank, 256), levels));
  return calls;
}

/// How many of the calls for all level counts give anything but `share` of the last level.
double other_levels(ShaderFunctions& shaders, const ShaderFunction& function, double value, double share) {
  const std::vector<ShaderInput> calls = at_all_levels(value);
  const Values found = numbers_of_calls(shaders, function, calls);
  double others = 0;
  for (std::size_t i = 0; i < calls.size(); ++i) others += found[i] != share * (double(calls[i][0].z) - 1);
  return others;
}

/// How many of 256 codes become another one of 256 levels, at any threshold of a matrix of 16 x 16.
double changed_codes(ShaderFunctions& shaders, const ShaderFunction& function) {
  std::vector<ShaderInput> calls;
  for (int code = 0; code < 256; ++code)
    for (int rank = 0; rank < 256; ++rank)
      calls.push_back(level_call(double(float(code) / 255), middle_of_rank(rank, 256), 256));
  const Values found = numbers_of_calls(shaders, function, calls);
  double changed = 0;
  for (std::size_t i = 0; i < calls.size(); ++i) changed += found[i] != double(i / 256);
  return changed;
}

/// How far the mean level over a Bayer matrix is from a flat value, at most over 250 values: in levels.
double mean_error(ShaderFunctions& shaders, const ShaderFunction& function, int size, int levels) {
  const std::vector<int> matrix = bayer_matrix(size);
  const int cells = size * size;
  Values values{0, 1};
  for (int i = 0; i < 248; ++i) values.push_back(double(float(Trial(940, i).between(0, 1))));
  std::vector<ShaderInput> calls;
  for (const double value : values)
    for (const int rank : matrix) calls.push_back(level_call(value, middle_of_rank(rank, cells), levels));
  const Values found = numbers_of_calls(shaders, function, calls);
  double worst = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    double sum = 0;
    for (int cell = 0; cell < cells; ++cell) sum += found[i * std::size_t(cells) + std::size_t(cell)];
    worst = worse_of(worst, std::abs(sum / cells - values[i] * (levels - 1)));
  }
  return worst;
}

enum class Growing { value, threshold };

/// How often a level falls though the value grows, or rises though the threshold does: 16 runs of 1000.
double wrong_turns(ShaderFunctions& shaders, const ShaderFunction& function, Growing growing) {
  double wrong = 0;
  for (int run = 0; run < 16; ++run) {
    Trial t(941, run);
    const int levels = std::array{2, 3, 16, 256}[std::size_t(run % 4)];
    const double kept = t.between(0.01, 0.99);
    std::vector<ShaderInput> calls;
    for (int i = 0; i < 1000; ++i) {
      const double grown = (i + 0.5) / 1000;
      calls.push_back(growing == Growing::value ? level_call(grown, kept, levels) : level_call(kept, grown, levels));
    }
    const Values found = numbers_of_calls(shaders, function, calls);
    for (std::size_t i = 1; i < found.size(); ++i)
      wrong += growing == Growing::value ? found[i] < found[i - 1] : found[i] > found[i - 1];
  }
  return wrong;
}

}  // namespace

void add_level_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("level_of (GLSL)");
  const ShaderFunction function = dither_function({"s"}, "vec4(level_of(s.x, s.y, s.z))");
  const auto of = [=, &shaders](double value, double threshold, int levels) {
    return Values{shaders.number(function, level_call(value, threshold, levels))};
  };
  group.equals("five levels, 0.6, thresholds of 0.3 and 0.5",
               [=] {
                 return Values{of(0.6, 0.3, 5)[0], of(0.6, 0.5, 5)[0]};
               },
               {3, 2});
  group.equals("0, 2 to 256 levels, 256 thresholds: levels that are not 0",
               [=, &shaders] { return Values{other_levels(shaders, function, 0, 0)}; }, {0});
  group.equals("1, 2 to 256 levels, 256 thresholds: levels that are not the last",
               [=, &shaders] { return Values{other_levels(shaders, function, 1, 1)}; }, {0});
  for (const int levels : {2, 3, 16, 256}) {
    const double last = levels - 1;
    for (const float threshold : {lowest_threshold, 0.5f, 1 - lowest_threshold}) {
      const auto words = [=](const char* what) {
        return fmt::format("{} levels, a threshold of {:.9g}: {}", levels, threshold, what);
      };
      const auto level = [=](float value) { return of(double(value), double(threshold), levels)[0]; };
      group.equals(words("0, -0, denormals of both signs, -1, -1e30, -infinity"),
                   [=] {
                     return Values{level(0),  level(-0.0f),  level(denormal), level(-denormal),
                                   level(-1), level(-1e30f), level(-infinite)};
                   },
                   {0, 0, 0, 0, 0, 0, 0});
      group.equals(
          words("1, the float above it, 2, 1e30, infinity"),
          [=] {
            return Values{level(1), level(std::nextafter(1.0f, 2.0f)), level(2), level(1e30f), level(infinite)};
          },
          {last, last, last, last, last});
      group.close(words("1000 values: the level below or above, as the threshold says"),
                  {4 * levels * rounding_unit, "levels", "a product, a sum and a difference of up to that many levels"},
                  [=, &shaders] {
                    return worst_of_calls(
                        shaders, function, 1000, 942,
                        [=](Trial& t) { return level_call(t.between(0, 1), double(threshold), levels); },
                        [](const ShaderInput& in, const glm::vec4& out) { return level_error(in, double(out.x)); });
                  });
    }
  }
  group.close("10000 random values from -1 to 2, thresholds, and counts of 2 to 256 levels",
              {4 * 256 * rounding_unit, "levels", "a product, a sum and a difference of up to 256 levels"},
              [=, &shaders] {
                return worst_of_calls(
                    shaders, function, 10'000, 943,
                    [](Trial& t) {
                      const double value = t.between(-1, 2), threshold = t.between(1e-4, 1 - 1e-4);
                      return level_call(value, threshold, int(t.between(2, 257)));
                    },
                    [](const ShaderInput& in, const glm::vec4& out) { return level_error(in, double(out.x)); });
              });
  group.equals("10000 random calls: levels that are no whole number of 0 .. levels - 1",
               [=, &shaders] {
                 return Values{worst_of_calls(
                     shaders, function, 10'000, 944,
                     [](Trial& t) {
                       const double value = t.between(-0.1, 1.1), threshold = t.between(1e-4, 1 - 1e-4);
                       return level_call(value, threshold, int(t.between(2, 257)));
                     },
                     [](const ShaderInput& in, const glm::vec4& out) {
                       return double(out.x != std::round(out.x) || out.x < 0 || out.x > in[0].z - 1);
                     })};
               },
               {0});
  group.equals("all codes of 8 bits, 256 levels, 256 thresholds: codes that change",
               [=, &shaders] { return Values{changed_codes(shaders, function)}; }, {0});
  group.close("10000 random values, 256 levels, any threshold: how far the level is from the value",
              {1 + 4 * 256 * rounding_unit, "levels", "one of the two levels next to it, up to roundings"},
              [=, &shaders] {
                return worst_of_calls(
                    shaders, function, 10'000, 945,
                    [](Trial& t) {
                      const double value = t.between(0, 1);
                      return level_call(value, t.between(1e-4, 1 - 1e-4), 256);
                    },
                    [](const ShaderInput& in, const glm::vec4& out) {
                      return std::abs(double(out.x) - 255 * double(in[0].x));
                    });
              });
  group.equals("values that grow, 16 runs of 1000: how often the level falls",
               [=, &shaders] { return Values{wrong_turns(shaders, function, Growing::value)}; }, {0});
  group.equals("thresholds that grow, 16 runs of 1000: how often the level rises",
               [=, &shaders] { return Values{wrong_turns(shaders, function, Growing::threshold)}; }, {0});
  for (const int size : {2, 4, 8, 16})
    for (const int levels : {2, 3, 64, 256})
      group.close(fmt::format("250 flat pictures, a matrix of {} x {}, {} levels: the mean", size, size, levels),
                  {0.5 / (size * size) + 4 * levels * rounding_unit, "levels",
                   "thresholds are one part of size^2 apart, and the value is at most half a part from the middle of "
                   "the nearest two; a rounding decides in a tie"},
                  [=, &shaders] { return mean_error(shaders, function, size, levels); });
  add_nan_row(group, shaders, function, level_call(0.6, 0.3, 5));
}

}  // namespace atelier::stability
