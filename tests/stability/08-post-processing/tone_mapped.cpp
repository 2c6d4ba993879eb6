// tone_mapped: exposures of 126 stops either way, before each curve.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

namespace {

enum ToneCurve { no_curve, reinhard_curve, filmic_curve };

/// A call: a colour with (stops, curve, white).
ShaderInput exposed(const glm::vec3& c, double stops, int curve, float white = 4) {
  return input_of(c, glm::vec3(stops, curve, white));
}

Colour exactly_mapped(const ShaderInput& in) {
  const Colour c = Colour(in[0]) * std::exp2(double(in[1].x));
  switch (int(in[1].y)) {
    case reinhard_curve:
      return exact_reinhard(c, double(in[1].z));
    case filmic_curve:
      return {exact_filmic(c.r), exact_filmic(c.g), exact_filmic(c.b)};
    default:
      return c;
  }
}

/// Twice what a relative error of the exposure of (3 + 2 |stops|) last places makes.
Bound exposure_bound(double stops) {
  return {2 * (3 + 2 * std::abs(stops)) * 2 * rounding_unit, "of the largest",
          "drivers' exp2(x) is good to 3 + 2 |x| of its last places, as later GLSL demands; no curve more than doubles "
          "that, and its own roundings are a dozen"};
}

}  // namespace

void add_tone_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("tone_mapped (GLSL)");
  const ShaderFunction function = post_function({"c", "by"}, "vec4(tone_mapped(c.rgb, by.x, int(by.y), by.z), 0.0)");
  const auto error = [](const ShaderInput& in, const Colour& out) {
    const Colour expected = exactly_mapped(in);
    const double size = int(in[1].y) == filmic_curve ? 1 : largest_of(expected);  // filmic: absolute
    return largest_of(out - expected) / size;
  };
  const auto error_of = [=, &shaders](const ShaderInput& in) {
    return error(in, Colour(shaders.evaluate(function, in)));
  };
  const glm::vec3 c(1, 0.5f, 0.25f);
  for (const int curve : {no_curve, reinhard_curve, filmic_curve}) {
    const char* name = std::array{"no curve", "Reinhard's", "filmic"}[std::size_t(curve)];
    for (const double stops : {-10.0, -1.0, 0.0, 1e-30, 1.0, 10.0})
      group.close(fmt::format("{}, {:g} stops", name, stops), exposure_bound(std::max(std::abs(stops), 1.0)),
                  [=] { return error_of(exposed(c, stops, curve)); });
    group.close(fmt::format("{}, light of 1e-30, 126 stops", name), exposure_bound(126),
                [=] { return error_of(exposed(1e-30f * c, 126, curve)); });
    group.close(fmt::format("{}, light of 1e30, 100 stops down", name), exposure_bound(100),
                [=] { return error_of(exposed(1e30f * c, -100, curve)); });
    group.close(fmt::format("{}, 10000 random colours up to 65504, 10 stops either way, whites from 0.1 to 100", name),
                exposure_bound(10), [=, &shaders] {
                  return worst_of_calls<Colour>(
                      shaders, function, 10'000, 860,
                      [=](Trial& t) {
                        const glm::vec3 light = some_light(t, 1e-3, double(largest_half));
                        const double stops = t.between(-10, 10);
                        return exposed(light, stops, curve, float(t.size_between(0.1, 100)));
                      },
                      error);
                });
    group.close(
        fmt::format("{}, 126 stops down", name),
        {4e-8, "absolute", "what is left, 1e-38, may be flushed to 0; the filmic curve ends with 1/15 less 1/15"},
        [=, &shaders] {
          return difference(colours_of(shaders, function, {exposed(c, -126, curve)}), {0, 0, 0});
        });
    add_nan_row(group, shaders, function, exposed(c, 1, curve), fmt::format("{}, ", name));
  }
  group.equals("black, 126 stops",
               [=, &shaders] {
                 return colours_of(shaders, function,
                                   {exposed(glm::vec3(0), 126, no_curve), exposed(glm::vec3(0), 126, reinhard_curve)});
               },
               {0, 0, 0, 0, 0, 0});
}

}  // namespace atelier::stability
