// colour_of: the borders of the gamut, where the greatest chroma that fits is a quotient of small numbers; and there
// and back.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

namespace {

/// A call with any hue of two turns either way, far too much chroma or far too little, and any luma.
ShaderInput some_parts(Trial& t) {
  const double hue = t.between(-2, 2), chroma = t.size_between(1e-6, 1e6);
  return input_of(glm::vec3(hue, chroma, t.between(0, 1)));
}

/// On the surface of the colour cube: one component is 0 and one is 1.
glm::vec3 saturated_colour(Trial& t) {
  glm::vec3 c = some_colour(t);
  const int low = int(t.between(0, 3));
  c[low] = 0;
  c[(low + (t.sign() > 0 ? 1 : 2)) % 3] = 1;
  return c;
}

/// How many of 2 x 12 hues become another colour than this grey; the hues around the whole circle, with far too much
/// chroma and with none.
double other_greys(ShaderFunctions& shaders, const ShaderFunction& function, float luma, const glm::vec2& chromas) {
  std::vector<ShaderInput> calls;
  for (int k = 0; k < 12; ++k)
    for (int i = 0; i < 2; ++i) calls.push_back(input_of(glm::vec3(float(k) / 12, chromas[i], luma)));
  return count_others(colours_of(shaders, function, calls), {double(luma)});
}

}  // namespace

void add_colour_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("colour_of (GLSL)");
  const ShaderFunction function = post_function({"p"}, "vec4(colour_of(p.x, p.y, p.z), 0.0)");
  const auto of = [=, &shaders](float hue, float chroma, float luma) {
    return colours_of(shaders, function, {input_of(glm::vec3(hue, chroma, luma))});
  };
  const Bound bound{
      2e-6, "absolute",
      "of a hue of up to 6 sixths 2.4e-7 is rounded away; the luma of the pure hue and a quotient add 1e-7 "
      "each, counted 1 / 0.07 times where yellow's luma is taken from 1"};
  for (const float luma : {0.0f, 1.0f, 2.0f, 1e30f})
    group.equals(fmt::format("a luma of {:g}, any hue, a chroma of 0 or 1e6: components of another amount", luma),
                 [=, &shaders] {
                   return Values{other_greys(shaders, function, luma, {0, 1e6f})};
                 },
                 {0});
  group.equals("no chroma, a luma of 0.3: components of another amount",
               [=, &shaders] {
                 return Values{other_greys(shaders, function, 0.3f, {0, 0})};
               },
               {0});
  for (const float luma : {1e-30f, 1e-7f, 1 - 0x1p-24f})
    group.close(fmt::format("a luma of {:.8g}, 1e6 of chroma: the luma is kept", luma),
                {2e-6, "relative",
                 "blue is 0.07 of a luma, so up to 14 times the luma is added of what has none but for 1.2e-7"},
                [=] {
                  double worst = 0;
                  for (const float hue : {0.0f, 0.1f, 0.25f, 0.5f, 0.7f, 0.9f}) {
                    const Values c = of(hue, 1e6f, luma);
                    worst = std::max(worst, relative_difference({luma_of({c[0], c[1], c[2]})}, {double(luma)}));
                  }
                  return worst;
                });
  for (const float luma : {0.05f, 0.3f, 0.9f})
    group.close(fmt::format("all six borders of sectors, and 1e-7 on either side, a luma of {:g}", luma), bound, [=] {
      double worst = 0;
      for (int sixths = 0; sixths <= 6; ++sixths)
        for (const double off : {-1e-7, 0.0, 1e-7}) {
          const float hue = float(sixths / 6.0 + off);
          worst = std::max(worst, difference(of(hue, 1e6f, luma), values(colour_with(double(hue), 1e6, double(luma)))));
        }
      return worst;
    });
  group.close("a hue of -1e-10: red", bound, [=] { return difference(of(-1e-10f, 1e6f, 0.2126f), {1, 0, 0}); });
  for (const float turns : {-1000.0f, -1.0f, 1.0f, 1000.0f})
    group.same(
        fmt::format("{:g} turns more, for hues of 64ths", turns),
        [=, &shaders] {
          std::vector<ShaderInput> calls;
          for (int k = 0; k < 64; ++k) calls.push_back(input_of(glm::vec3(float(k) / 64 + turns, 0.5f, 0.4f)));
          return colours_of(shaders, function, calls);
        },
        [=, &shaders] {
          std::vector<ShaderInput> calls;
          for (int k = 0; k < 64; ++k) calls.push_back(input_of(glm::vec3(float(k) / 64, 0.5f, 0.4f)));
          return colours_of(shaders, function, calls);
        });

  const auto worst = [=, &shaders](auto error) {
    return worst_of_calls<Colour>(shaders, function, 10'000, 820, some_parts,
                                  [=](const ShaderInput& in, const Colour& out) {
                                    return error(double(in[0].x), double(in[0].y), double(in[0].z), out);
                                  });
  };
  const std::string trials = "10000 random hues and lumas, chromas of 1e-6 to 1e6: ";
  group.close(trials + "the greatest that fits", bound, [=] {
    return worst([](double hue, double chroma, double luma, const Colour& out) {
      return largest_of(out - colour_with(hue, chroma, luma));
    });
  });
  group.close(
      trials + "the luma is kept",
      {4 * rounding_unit, "absolute", "of up to 1: the luma of what is added, which is 0, and three sums"}, [=] {
        return worst([](double, double, double luma, const Colour& out) { return std::abs(luma_of(out) - luma); });
      });
  group.close(trials + "the hue is kept",
              {1e-6, "sixths of a turn times chroma",
               "of up to 6 sixths 2.4e-7 is rounded away; the components that say it back are rounded by 1.2e-7 each"},
              [=] {
                return worst([](double hue, double, double, const Colour& out) {
                  return 6 * turns_between(hue_of(out), hue) * chroma_of(out);
                });
              });
  group.close(trials + "the chroma does not grow",
              {4 * rounding_unit, "absolute", "two components of up to 1, each a product and a sum"}, [=] {
                return worst([](double, double chroma, double, const Colour& out) {
                  return std::max(chroma_of(out) - chroma, 0.0);
                });
              });
  group.equals(trials + "components below 0",
               [=] {
                 return Values{
                     worst([](double, double, double, const Colour& out) { return count_outside(values(out), 0, 2); })};
               },
               {0});
  group.close(trials + "none is above 1", {4 * rounding_unit, "absolute", "a quotient, a product and a sum"}, [=] {
    return worst([](double, double, double, const Colour& out) { return std::max(largest_of(out) - 1, 0.0); });
  });
  add_nan_row(group, shaders, function, input_of(glm::vec3(0.1f, 0.5f, 0.3f)));
}

void add_round_trip_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("colour_of(hue_chroma_luma) (GLSL)");
  const ShaderFunction function =
      post_function({"c"}, "vec4(there_and_back(c.rgb), 0.0)",
                    "vec3 there_and_back(vec3 c) { vec3 p = hue_chroma_luma(c); return colour_of(p.x, p.y, p.z); }\n");
  const auto worst = [=, &shaders](float size, auto colour) {
    return worst_of_calls<Colour>(
        shaders, function, 10'000, 825, [=](Trial& t) { return input_of(size * colour(t)); },
        [=](const ShaderInput& in, const Colour& out) { return largest_of(out - Colour(in[0])) / double(size); });
  };
  for (const float size : {1e-30f, 1e-6f, 1.0f})
    group.close(fmt::format("10000 random colours up to {:g}", size),
                {1e-6, "of the largest",
                 "hue, chroma and luma are rounded, and the sums that they come back by: some ten roundings, the hue's "
                 "counted six times; a 4000th of a step of 8 bits"},
                [=] { return worst(size, some_colour); });
  group.close(
      "10000 colours with one component of 0 and one of 1",
      {5e-6, "absolute",
       "their chroma just fits, and is limited by what the luma leaves below 1: 0.07 for yellow, which counts a "
       "rounding of the luma and one of yellow's 14 times"},
      [=] { return worst(1, saturated_colour); });
  group.close("10000 greys with up to 1e-7 more in a component",
              {4 * rounding_unit, "absolute", "a product and a sum, and the luma"}, [=] {
                return worst(1, [](Trial& t) {
                  const double grey = t.between(0, 1);
                  return glm::vec3(grey + t.between(0, 1e-7), grey + t.between(0, 1e-7), grey + t.between(0, 1e-7));
                });
              });
}

}  // namespace atelier::stability
