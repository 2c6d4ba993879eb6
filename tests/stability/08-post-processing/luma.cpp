// luma: from the smallest light to the largest.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

void add_luma_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("luma (GLSL)");
  const ShaderFunction function = post_function({"c"}, "vec4(luma(c.rgb))");
  const auto of = [=, &shaders](const glm::vec3& c) { return Values{shaders.number(function, input_of(c))}; };
  const Bound rounded{4 * rounding_unit, "relative",
                      "of a sum of positive numbers: a weight, a product and two sums are rounded"};
  group.equals("black", [=] { return of({0, 0, 0}); }, {0});
  for (int i = 0; i < 3; ++i)
    group.close(fmt::format("component {} of 1e30, nothing of the others", i), rounded, [=] {
      glm::vec3 c(0);
      c[i] = 1e30f;
      return relative_difference(of(c), {luma_of(Colour(c))});
    });
  for (const float grey : {1e-30f, 1e-7f, 0.18f, 1.0f, largest_half, 1e30f, 1e38f})
    group.close(fmt::format("a grey of {:g}: itself", grey), rounded,
                [=] { return relative_difference(of(glm::vec3(grey)), {double(grey)}); });
  group.close("a denormal grey: itself, or 0", {double(denormal), "absolute", "drivers may flush denormals to 0"},
              [=] { return difference(of(glm::vec3(denormal)), {double(denormal)}); });
  group.close("10000 random colours, each component from 1e-30 to 1e30", rounded, [=, &shaders] {
    return worst_of_calls<Colour>(
        shaders, function, 10'000, 800, [](Trial& t) { return input_of(some_light(t, 1e-30, 1e30)); },
        [](const ShaderInput& in, const Colour& out) {
          const double expected = luma_of(Colour(in[0]));
          return std::abs(out.r - expected) / expected;
        });
  });
  add_nan_row(group, shaders, function, input_of(glm::vec3(0.5f, 0.25f, 0.125f)));
}

}  // namespace atelier::stability
