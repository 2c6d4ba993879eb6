// adjusted: no change, no saturation and too much of it, no brightness and too much of it, light above 1.
#include "stability/08-post-processing/rows.hpp"

namespace atelier::stability {

namespace {

/// A call: a colour with (turns, saturation, brightness).
using Change = glm::vec3;

ShaderInput some_adjustment(Trial& t) {
  const glm::vec3 c = some_colour(t);
  const double turns = t.between(-2, 2), saturation = t.size_between(1e-3, 1e6);
  return input_of(c, Change(turns, saturation, t.between(0, 2)));
}

Colour exactly_adjusted(const Colour& c, const Colour& change) {
  return colour_with(hue_of(c) + change.x, chroma_of(c) * change.y, luma_of(c) * change.z);
}

}  // namespace

void add_adjusted_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("adjusted (GLSL)");
  const ShaderFunction function = post_function({"c", "by"}, "vec4(adjusted(c.rgb, by.x, by.y, by.z), 0.0)");
  const auto worst = [=, &shaders](auto colour, const Change& change, auto error) {
    return worst_of_calls<Colour>(
        shaders, function, 10'000, 830, [=](Trial& t) { return input_of(colour(t), change); },
        [=](const ShaderInput& in, const Colour& out) { return error(Colour(in[0]), out); });
  };
  const auto moved = [](const Colour& c, const Colour& out) { return largest_of(out - c); };
  const auto luma_error = [](double factor) {
    return [=](const Colour& c, const Colour& out) {
      const double expected = factor * luma_of(c);
      return std::abs(luma_of(out) - expected) / std::max(1.0, expected);
    };
  };
  const Bound luma_bound{8 * rounding_unit, "relative, of at least 1",
                         "the luma is four roundings, the colour made of it a product and two sums"};

  group.close("no change: 10000 random colours stay",
              {1e-6, "absolute", "some ten roundings, the hue's counted six times"}, [=] {
                return worst(some_colour, {0, 1, 1}, moved);
              });
  for (const float turns : {-2.0f, -1.0f, 1.0f, 2.0f})
    group.close(
        fmt::format("{:g} turns: 10000 random colours stay", turns),
        {2e-6, "absolute", "a hue of up to 3 turns is rounded by 1.2e-7, which counts six times, and no change"}, [=] {
          return worst(some_colour, {turns, 1, 1}, moved);
        });
  group.close("1000 turns: 10000 random colours stay",
              {2e-4, "absolute", "a hue of 1000 turns is rounded by 3.1e-5, which counts six times"}, [=] {
                return worst(some_colour, {1000, 1, 1}, moved);
              });
  group.close("1e6 turns, which are too many for a hue: the luma is kept", luma_bound, [=] {
    return worst(some_colour, {1e6f, 1, 1}, luma_error(1));
  });

  const auto uneven = [](const Colour&, const Colour& out) { return chroma_of(out); };
  group.equals("a saturation of 0: the chroma of 10000 random colours",
               [=] {
                 return Values{worst(some_colour, {0.3f, 0, 1}, uneven)};
               },
               {0});
  group.close("a saturation of 0: the luma is kept", luma_bound, [=] {
    return worst(some_colour, {0.3f, 0, 1}, luma_error(1));
  });
  group.close("a saturation of 1e6: the luma is kept", luma_bound, [=] {
    return worst(some_colour, {0, 1e6f, 1}, luma_error(1));
  });
  group.close("a saturation of 1e6: the hue is kept",
              {1e-6, "sixths of a turn times chroma", "the hue's rounding counted six times, and two components'"},
              [=] {
                return worst(some_colour, {0, 1e6f, 1}, [](const Colour& c, const Colour& out) {
                  return 6 * turns_between(hue_of(c), hue_of(out)) * chroma_of(out);
                });
              });
  group.equals(
      "a saturation of 1e6 and a third of a turn: greys get no chroma",
      [=] {
        return Values{worst([](Trial& t) { return glm::vec3(float(t.between(0, 1))); }, {1.0f / 3, 1e6f, 1}, uneven)};
      },
      {0});
  group.close("a saturation of 1e6, greys with up to 1e-7 more in a component: the luma is kept", luma_bound, [=] {
    return worst(
        [](Trial& t) {
          const double grey = t.between(0, 1);
          return glm::vec3(grey + t.between(0, 1e-7), grey, grey + t.between(0, 1e-7));
        },
        {0, 1e6f, 1}, luma_error(1));
  });

  group.equals("a brightness of 0: the largest component of 10000 random colours",
               [=] {
                 return Values{worst(some_colour, {0.3f, 2, 0},
                                     [](const Colour&, const Colour& out) { return largest_of(out); })};
               },
               {0});
  group.close("a brightness of 1e6: the luma is 1e6 times as large", luma_bound, [=] {
    return worst(some_colour, {0.3f, 2, 1e6f}, luma_error(1e6));
  });
  group.equals("a brightness of 1e6: the chroma of 10000 random colours",
               [=] {
                 return Values{worst([](Trial& t) { return some_colour(t) + 0.001f; }, {0.3f, 2, 1e6f}, uneven)};
               },
               {0});
  group.close("light up to 65504: the luma is kept", luma_bound, [=] {
    return worst([](Trial& t) { return some_light(t, 1e-3, double(largest_half)); }, {0.3f, 2, 1}, luma_error(1));
  });
  group.equals("black",
               [=, &shaders] {
                 return colours_of(
                     shaders, function,
                     {input_of(glm::vec3(0), Change(0, 1, 1)), input_of(glm::vec3(0), Change(1, 1e6f, 1e6f))});
               },
               {0, 0, 0, 0, 0, 0});
  group.close("10000 random colours, up to 2 turns either way, saturations of 1e-3 to 1e6, brightnesses up to 2",
              {6e-6, "of the largest, at least 1",
               "2e-6 by the hue; what the luma leaves below 1 is 0.07 for yellow, which counts roundings 14 times"},
              [=, &shaders] {
                return worst_of_calls<Colour>(shaders, function, 10'000, 831, some_adjustment,
                                              [](const ShaderInput& in, const Colour& out) {
                                                const Colour expected = exactly_adjusted(Colour(in[0]), Colour(in[1]));
                                                return largest_of(out - expected) / std::max(1.0, largest_of(expected));
                                              });
              });
  group.finite("denormal components", [=, &shaders] {
    return colours_of(shaders, function, {input_of(glm::vec3(denormal, 2 * denormal, 0), Change(0.3f, 1e6f, 1e6f))});
  });
  add_nan_row(group, shaders, function, input_of(glm::vec3(0.5f, 0.25f, 0.125f), Change(0.3f, 2, 0.75f)));
}

}  // namespace atelier::stability
