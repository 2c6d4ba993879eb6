// threshold_of: patterns of 1 cell to 256 x 256.
#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

namespace {

/// A call for each rank, or for the first and last 8192 of more.
std::vector<ShaderInput> calls_for_ranks(int count) {
  std::vector<ShaderInput> calls;
  for (int rank = 0; rank < count; ++rank)
    if (rank < 8192 || rank >= count - 8192) calls.push_back(input_of(float(rank), float(count)));
  return calls;
}

}  // namespace

void add_threshold_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("threshold_of (GLSL)");
  const ShaderFunction function = dither_function({"rank", "count"}, "vec4(threshold_of(rank.x, count.x))");
  for (const int count : {1, 4, 16, 25, 64, 256, 1089, 4096, 65536}) {
    const auto words = [=](const char* what) { return fmt::format("{} ranks: {}", count, what); };
    group.close(
        words("the middle of each part"),
        {6 * rounding_unit, "relative", "drivers round a quotient to 2.5 of its last places; the rest is exact"},
        [=, &shaders] {
          const std::vector<ShaderInput> calls = calls_for_ranks(count);
          Values expected;
          for (const ShaderInput& in : calls) expected.push_back((2 * double(in[0].x) + 1) / (2.0 * count));
          return each_relative(numbers_of_calls(shaders, function, calls), expected);
        });
    group.equals(words("those that are not above 0 and below 1, and not above the one before"),
                 [=, &shaders] {
                   const Values found = numbers_of_calls(shaders, function, calls_for_ranks(count));
                   double outside = 0, falling = 0;
                   for (std::size_t i = 0; i < found.size(); ++i) {
                     outside += !(found[i] > 0 && found[i] < 1);
                     falling += i > 0 && !(found[i] > found[i - 1]);
                   }
                   return Values{outside, falling};
                 },
                 {0, 0});
    group.close(words("first and last, second and last but one ... together are 1"),
                {6 * rounding_unit, "absolute", "drivers round each quotient to 2.5 of its last places"},
                [=, &shaders] {
                  const Values found = numbers_of_calls(shaders, function, calls_for_ranks(count));
                  double worst = 0;
                  for (std::size_t i = 0; i < found.size(); ++i)
                    worst = worse_of(worst, std::abs(found[i] + found[found.size() - 1 - i] - 1));
                  return worst;
                });
  }
}

}  // namespace atelier::stability
