// bright_part: a luma that is the threshold, or a float more; thresholds of 0; light from 1e-30 to 1e30.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

namespace {

Colour exact_bright_part(const Colour& c, double threshold) {
  const double y = luma_of(c);
  return y > threshold ? c * ((y - threshold) / y) : Colour(0);
}

}  // namespace

void add_bright_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("bright_part (GLSL)");
  const ShaderFunction function = post_function({"c", "threshold"}, "vec4(bright_part(c.rgb, threshold.x), 0.0)");
  const auto of = [=, &shaders](const glm::vec3& c, float threshold) {
    return colours_of(shaders, function, {input_of(c, threshold)});
  };
  const Bound bound{
      8 * rounding_unit, "of the colour",
      "a luma of four roundings, a difference, a quotient, which drivers round to 2.5 of its last places, "
      "and a product"};
  for (const float threshold : {0.0f, 1e-30f, 1.0f, 16.0f})
    group.equals(fmt::format("black, a threshold of {:g}", threshold),
                 [=] {
                   return of({0, 0, 0}, threshold);
                 },
                 {0, 0, 0});

  // Against thresholds that are made of the luma of the very colour.
  const auto at_luma = [&shaders](const char* threshold, auto error) {
    const ShaderFunction same = post_function({"c"}, fmt::format("vec4(bright_part(c.rgb, {}), 0.0)", threshold));
    return worst_of_calls<Colour>(
        shaders, same, 10'000, 880, [](Trial& t) { return input_of(some_light(t, 1e-3, double(largest_half))); },
        error);
  };
  group.equals("the threshold is the luma: 10000 random colours that are not black",
               [=] {
                 return Values{at_luma("luma(c.rgb)", [](const ShaderInput&, const Colour& out) {
                   return count_others(values(out), {0});
                 })};
               },
               {0});
  group.close("the threshold is a float below the luma: 10000 random colours are black or nearly",
              {4 * rounding_unit, "of the colour", "a float is up to 2^-23 of the luma, and the quotient is rounded"},
              [=] {
                return at_luma("uintBitsToFloat(floatBitsToUint(luma(c.rgb)) - 1u)",
                               [](const ShaderInput& in, const Colour& out) {
                                 const bool negative = std::min({out.r, out.g, out.b}) < 0;
                                 return negative ? double(INFINITY) : largest_of(out) / largest_of(Colour(in[0]));
                               });
              });
  group.equals(
      "the threshold is a float above the luma: 10000 random colours that are not black",
      [=] {
        return Values{at_luma("uintBitsToFloat(floatBitsToUint(luma(c.rgb)) + 1u)",
                              [](const ShaderInput&, const Colour& out) { return count_others(values(out), {0}); })};
      },
      {0});
  for (const float size : {1e-30f, 1e-6f, 1.0f, largest_half, 1e30f}) {
    const glm::vec3 c = size * glm::vec3(1, 0.5f, 0.25f);
    for (const float threshold : {0.0f, 1.0f, 16.0f})
      group.close(fmt::format("a colour of {:g}, a threshold of {:g}", size, threshold), bound, [=] {
        return difference(of(c, threshold), values(exact_bright_part(Colour(c), double(threshold)))) / double(size);
      });
  }
  group.close("10000 random colours, each component from 1e-6 to 65504, thresholds from 1e-4 to 16", bound,
              [=, &shaders] {
                return worst_of_calls<Colour>(
                    shaders, function, 10'000, 881,
                    [](Trial& t) {
                      const glm::vec3 c = some_light(t, 1e-6, double(largest_half));
                      return input_of(c, float(t.size_between(1e-4, 16)));
                    },
                    [](const ShaderInput& in, const Colour& out) {
                      const Colour c(in[0]);
                      return largest_of(out - exact_bright_part(c, double(in[1].x))) / largest_of(c);
                    });
              });
  group.finite("denormal components, a threshold of 0", [=] { return of({denormal, 2 * denormal, 0}, 0); });
  group.equals("a NaN: no luma that exceeds the threshold, so black, and the blur never sees it",
               [=] {
                 return of({not_a_number, 0.5f, 16}, 1);
               },
               {0, 0, 0});
  add_nan_row(group, shaders, function, input_of(glm::vec3(5, 2, 1), 1.0f));
}

}  // namespace atelier::stability
