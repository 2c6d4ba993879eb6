// reinhard: whites of 1e-3 to 1e6, light of 1e-30 to 1e15.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

Colour exact_reinhard(const Colour& c, double white) {
  const double y = luma_of(c);
  return c / (1 + y) + c * (y / (1 + y)) / white / white;
}

// The squares of floats end at 1.8e19. The largest half, ten stops up, is 6.7e7: all that the program lets through.
void add_reinhard_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("reinhard (GLSL)");
  const ShaderFunction function = post_function({"c", "white"}, "vec4(reinhard(c.rgb, white.x), 0.0)");
  const auto of = [=, &shaders](const glm::vec3& c, float white) {
    return colours_of(shaders, function, {input_of(c, white)});
  };
  const Bound bound{
      12 * rounding_unit, "relative",
      "a luma of four roundings, two quotients, which drivers round to 2.5 of their last places, two sums "
      "and two products"};
  for (const float white : {1e-3f, 0.1f, 1.0f, 4.0f, 100.0f, 1e6f}) {
    group.equals(fmt::format("black, white {:g}", white), [=] { return of({0, 0, 0}, white); }, {0, 0, 0});
    group.close(fmt::format("white {:g} becomes 1", white), bound, [=] {
      return difference(of(glm::vec3(white), white), {1, 1, 1});
    });
    for (const float size : {1e-30f, 1e-6f, 1e-3f, largest_half, 6.7e7f, 1e15f})
      group.close(fmt::format("a colour of {:g}, white {:g}", size, white), bound, [=] {
        const glm::vec3 c = size * glm::vec3(1, 0.5f, 0.25f);
        return each_relative(of(c, white), values(exact_reinhard(Colour(c), double(white))));
      });
  }
  group.close("10000 random colours, each component from 1e-6 to 65504, whites from 1e-3 to 1e6", bound, [=, &shaders] {
    return worst_of_calls<Colour>(
        shaders, function, 10'000, 840,
        [](Trial& t) {
          const glm::vec3 c = some_light(t, 1e-6, double(largest_half));
          return input_of(c, float(t.size_between(1e-3, 1e6)));
        },
        [](const ShaderInput& in, const Colour& out) {
          return each_relative(values(out), values(exact_reinhard(Colour(in[0]), double(in[1].x))));
        });
  });
  group.equals("greys of 0 to 64 in 4096 steps, white 4: how often it falls",
               [=, &shaders] {
                 std::vector<ShaderInput> calls;
                 for (int i = 0; i <= 4096; ++i) calls.push_back(input_of(glm::vec3(float(i) / 64), 4.0f));
                 const Values y = shaders.numbers(function, calls);
                 double falls = 0;
                 for (std::size_t i = 1; i < y.size(); ++i) falls += !(y[i] > y[i - 1]);
                 return Values{falls};
               },
               {0});
  group.finite("denormal components", [=] { return of({denormal, 2 * denormal, 0}, 4); });
  add_nan_row(group, shaders, function, input_of(glm::vec3(0.5f, 0.25f, 0.125f), 4.0f));
}

}  // namespace atelier::stability
