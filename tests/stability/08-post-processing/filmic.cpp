// filmic: black, where the curve is a difference of equal numbers, and the light at which it is flat.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

double exact_filmic(double x) {
  // h(x) as one quotient: E / F = 1/15 cancels the constant terms, so nothing is lost near black.
  const auto h = [](double v) {
    const double below = v * (0.15 * v + 0.5) + 0.06;
    return v * (0.15 * v * (14.0 / 15) + 0.05 - 0.5 / 15) / below;
  };
  return h(2 * x) / h(11.2);
}

// The squares of floats end at 1.8e19. The largest half, ten stops up, is 6.7e7: all that the program lets through.
void add_filmic_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("filmic (GLSL)");
  const ShaderFunction function = post_function({"c"}, "vec4(filmic(c.rgb), 0.0)");
  const auto of = [=, &shaders](const glm::vec3& c) { return colours_of(shaders, function, {input_of(c)}); };
  const Bound near_black{
      4e-8, "absolute", "1/15 less 1/15, a quotient of drivers less a constant, is up to 2e-8, and is divided by 0.73"};
  const Bound bound{16 * rounding_unit, "absolute",
                    "of up to 1.3: two quotients, which drivers round to 2.5 of their last places, and a dozen others"};
  for (const float x : {0.0f, denormal, 1e-30f, 1e-9f})
    group.close(fmt::format("a grey of {:g}", x), near_black,
                [=] { return difference(of(glm::vec3(x)), Values(3, exact_filmic(double(x)))); });
  group.close("5.6 becomes 1", bound, [=] { return difference(of(glm::vec3(5.6f)), {1, 1, 1}); });
  for (const float x : {1e-6f, 1e-3f, 0.18f, 1.0f, 100.0f, largest_half, 6.7e7f, 1e18f})
    group.close(fmt::format("a grey of {:g}", x), bound,
                [=] { return difference(of(glm::vec3(x)), Values(3, exact_filmic(double(x)))); });
  group.same(
      "each component by itself: 1e18 beside 0 and 0.18",
      [=] {
        return of({1e18f, 0, 0.18f});
      },
      [=] {
        return Values{of(glm::vec3(1e18f))[0], of(glm::vec3(0))[1], of(glm::vec3(0.18f))[2]};
      });
  group.close("10000 random colours, each component from 1e-6 to 1e6", bound, [=, &shaders] {
    return worst_of_calls<Colour>(
        shaders, function, 10'000, 850, [](Trial& t) { return input_of(some_light(t, 1e-6, 1e6)); },
        [](const ShaderInput& in, const Colour& out) {
          const Colour c(in[0]);
          return largest_of(out - Colour(exact_filmic(c.r), exact_filmic(c.g), exact_filmic(c.b)));
        });
  });
  group.equals("greys of 0 to 64 in 4096 steps: how often it falls",
               [=, &shaders] {
                 std::vector<ShaderInput> calls;
                 for (int i = 0; i <= 4096; ++i) calls.push_back(input_of(glm::vec3(float(i) / 64)));
                 const Values y = shaders.numbers(function, calls);
                 double falls = 0;
                 for (std::size_t i = 1; i < y.size(); ++i) falls += !(y[i] > y[i - 1]);
                 return Values{falls};
               },
               {0});
  add_nan_row(group, shaders, function, input_of(glm::vec3(0.5f, 0.25f, 0.125f)));
}

}  // namespace atelier::stability
