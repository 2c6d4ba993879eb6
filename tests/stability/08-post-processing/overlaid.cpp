// overlaid: exactly one picture where the other is not seen, whatever light that has.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

namespace {

constexpr std::array layers = {0.0f, 1e-30f, 0.1f, 1.0f / 3, 0.7f, 1.0f, 16.0f, largest_half, 1e30f};

/// All pairs of layers, the one above with this opacity and amount.
std::vector<ShaderInput> stacks(float opacity, float amount) {
  std::vector<ShaderInput> calls;
  for (const float below : layers)
    for (const float above : layers)
      calls.push_back(input_of(glm::vec4(glm::vec3(below), 0.25f), glm::vec4(glm::vec3(above), opacity), amount));
  return calls;
}

}  // namespace

void add_overlaid_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("overlaid (GLSL)");
  const ShaderFunction function = post_function({"below", "above", "amount"}, "overlaid(below, above, amount.x)");
  // How many of the stacks are not exactly the layer that is argument `layer`.
  const auto others = [=, &shaders](float opacity, float amount, std::size_t layer) {
    const std::vector<ShaderInput> calls = stacks(opacity, amount);
    const std::vector<glm::vec4> found = shaders.evaluate(function, calls);
    double count = 0;
    for (std::size_t i = 0; i < calls.size(); ++i) count += glm::vec3(found[i]) != glm::vec3(calls[i][layer]);
    return Values{count};
  };
  const std::string pairs = fmt::format("{} pairs of 0 to 1e30: ", layers.size() * layers.size());
  group.equals(pairs + "an amount of 0, other colours than below", [=] { return others(1, 0, 0); }, {0});
  group.equals(pairs + "an opacity of 0, other colours than below", [=] { return others(0, 1, 0); }, {0});
  group.equals(pairs + "both 1, other colours than above", [=] { return others(1, 1, 1); }, {0});
  group.equals("the opacity is that of below",
               [=, &shaders] {
                 Values opacities;
                 for (const float opacity : {0.0f, 1e-30f, 0.25f, 1.0f})
                   opacities.push_back(double(
                       shaders.evaluate(function, input_of(glm::vec4(0, 0, 0, opacity), glm::vec4(0.5f), 0.5f)).a));
                 return opacities;
               },
               {0, double(1e-30f), 0.25, 1});
  group.close(
      "an amount of 1e-30: below", {rounding_unit, "of the largest", "what is added is rounded away"}, [=, &shaders] {
        return relative_difference(
            colours_of(shaders, function, {input_of(glm::vec4(1, 0.5f, 0, 1), glm::vec4(1), 1e-30f)}), {1, 0.5, 0});
      });
  group.close("10000 random layers up to 65504",
              {6 * rounding_unit, "of the largest", "two products, a sum, and the product and the rest of the share"},
              [=, &shaders] {
                return worst_of_calls<Colour>(
                    shaders, function, 10'000, 870,
                    [](Trial& t) {
                      const glm::vec3 below = some_light(t, 1e-3, double(largest_half)),
                                      above = some_light(t, 1e-3, double(largest_half));
                      const double opacity = t.between(0, 1);
                      return input_of(glm::vec4(below, 1), glm::vec4(above, opacity), float(t.between(0, 1)));
                    },
                    [](const ShaderInput& in, const Colour& out) {
                      const Colour below(in[0]), above(in[1]);
                      const double share = double(in[1].a) * double(in[2].x);
                      return largest_of(out - (below + share * (above - below))) /
                             std::max(largest_of(below), largest_of(above));
                    });
              });
  add_nan_row(group, shaders, function, input_of(glm::vec4(0.5f, 0.25f, 0.125f, 1), glm::vec4(0.7f), 0.5f));
}

}  // namespace atelier::stability
