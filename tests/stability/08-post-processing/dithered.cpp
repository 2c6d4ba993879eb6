// dithered: the mean over all noise, at black, at white and between two codes.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

namespace {

/// The mean of what is stored in 8 bits for a value, over 256 noises that are evenly spread, in steps of 1/255.
double mean_code(ShaderFunctions& shaders, const ShaderFunction& function, float stored) {
  std::vector<ShaderInput> calls;
  for (int i = 0; i < 256; ++i) calls.push_back(input_of(glm::vec4(glm::vec3(stored), (float(i) + 0.5f) / 256)));
  double sum = 0;
  for (const double value : shaders.numbers(function, calls)) sum += std::round(255 * std::clamp(value, 0.0, 1.0));
  return sum / 256;
}

}  // namespace

void add_dithered_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("dithered (GLSL)");
  const ShaderFunction function = post_function({"s"}, "vec4(dithered(s.rgb, s.a), 0.0)");
  const Bound mean_bound{1.0 / 128, "steps of 8 bits",
                         "256 noises give a mean in steps of 1/256, and a rounding of the value may move one of them"};
  for (const float stored : {0.0f, denormal, 1e-7f, 1e-4f, 0.5f / 255, 1.0f / 255, 0.5f, 254.5f / 255, 1.0f})
    group.close(fmt::format("a value of {:.9g}: the mean stays", stored), mean_bound,
                [=, &shaders] { return std::abs(mean_code(shaders, function, stored) - 255 * double(stored)); });
  group.close("200 random values: the mean stays", mean_bound, [=, &shaders] {
    return worst_of(200, 920, [=, &shaders](Trial& t) {
      const float stored = float(t.between(0, 1));
      return std::abs(mean_code(shaders, function, stored) - 255 * double(stored));
    });
  });
  group.close("10000 random values and noises: never more than half a step away",
              {1e-4, "steps of 8 bits", "a value of up to 1 is rounded by 6e-8, 1.5e-5 of a step, and so is the noise"},
              [=, &shaders] {
                return worst_of_calls<Colour>(
                    shaders, function, 10'000, 921,
                    [](Trial& t) {
                      const glm::vec3 stored = some_colour(t);
                      return input_of(glm::vec4(stored, t.between(0, 1)));
                    },
                    [](const ShaderInput& in, const Colour& out) {
                      return std::max(255 * largest_of(out - Colour(in[0])) - 0.5, 0.0);
                    });
              });
  group.close("a noise of 1/2: nothing changes", {rounding_unit, "absolute", "a noise of no size is added"},
              [=, &shaders] {
                const Values stored = {0, 0.25, 1};
                return difference(colours_of(shaders, function, {input_of(glm::vec4(0, 0.25f, 1, 0.5f))}), stored);
              });
  group.equals("10000 greys: the chroma that they get",
               [=, &shaders] {
                 return Values{worst_of_calls<Colour>(
                     shaders, function, 10'000, 922,
                     [](Trial& t) {
                       const double grey = t.between(0, 1);
                       return input_of(glm::vec4(glm::vec3(float(grey)), t.between(0, 1)));
                     },
                     [](const ShaderInput&, const Colour& out) { return chroma_of(out); })};
               },
               {0});
  add_nan_row(group, shaders, function, input_of(glm::vec4(0.5f, 0.25f, 0.125f, 0.3f)));
}

}  // namespace atelier::stability
