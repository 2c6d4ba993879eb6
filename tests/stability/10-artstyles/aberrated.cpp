// aberrated: the centre, an amount of 0, even pictures, phases of up to a million turns.
#include "stability/10-artstyles/texels.hpp"

namespace atelier::stability {

namespace {

/// A call: texture coordinates, (amount, turns).
ShaderInput aberration_call(const glm::vec2& texcoord, double amount, double turns) {
  return input_of(texcoord, glm::vec2(amount, turns));
}

std::vector<glm::vec4> aberrated_colours(ShaderFunctions& shaders, const Texels& texels, bool linear,
                                         const std::vector<ShaderInput>& calls) {
  return results_with(shaders, texels, linear, {"texcoord", "s"},
                      "vec4(aberrated(u_texels, texcoord.xy, s.x, s.y), 1.0)", calls);
}

std::vector<ShaderInput> pixel_calls(const Texels& texels, double amount, double turns) {
  std::vector<ShaderInput> calls;
  for (int y = 0; y < texels.height; ++y)
    for (int x = 0; x < texels.width; ++x)
      calls.push_back(aberration_call((glm::vec2(x, y) + 0.5f) / texels.size(), amount, turns));
  return calls;
}

std::vector<ShaderInput> random_calls(double amount, double turns) {
  std::vector<ShaderInput> calls;
  for (int i = 0; i < 2000; ++i) {
    Trial t(1160, i);
    const double x = t.between(0, 1);
    calls.push_back(aberration_call(glm::vec2(x, t.between(0, 1)), amount, turns));
  }
  return calls;
}

/// How far the places of all channels are from the right ones, at most: in pictures of either coordinate.
double channel_places_error(ShaderFunctions& shaders, const std::vector<ShaderInput>& calls) {
  double worst = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const std::vector<glm::vec4> found = aberrated_colours(shaders, coordinate_texels(axis), true, calls);
    for (std::size_t i = 0; i < calls.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        const double turns = double(calls[i][1].y) + c / 3.0, part = turns - std::floor(turns);
        const double factor = 1 + double(calls[i][1].x) * std::sin(2 * std::numbers::pi * part);
        const double right = read_coordinate(0.5 + (double(calls[i][0][axis]) - 0.5) * factor);
        worst = worse_of(worst, std::abs(double(found[i][c]) - right));
      }
  }
  return worst;
}

}  // namespace

void add_aberrated_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("aberrated (GLSL)");
  group.equals("the centre, amounts of 0 to 1, 0 to 1e6 turns: channels that change",
               [&shaders] {
                 const Texels texels = random_texels(5, 7, 0, 2);
                 std::vector<ShaderInput> calls;
                 for (const double amount : {0.0, 1e-30, 0.01, 1.0})
                   for (const double turns : {0.0, 0.25, 1.0 / 3, 100.0, 1e6})
                     calls.push_back(aberration_call(glm::vec2(0.5f), amount, turns));
                 double others = 0;
                 for (const glm::vec4& c : aberrated_colours(shaders, texels, false, calls))
                   others += c != texels.clamped(2, 3);
                 return Values{others};
               },
               {0});
  for (const double turns : {0.0, 0.1, 1e6})
    for (const auto& [width, height] : {std::pair{1, 1}, {64, 40}, {1, 300}, {4000, 1}})
      group.equals(fmt::format("an amount of 0, {:g} turns, {} x {}: pixels that change", turns, width, height),
                   [=, &shaders, width = width, height = height] {
                     const Texels texels = random_texels(width, height, 0, 2);
                     const std::vector<glm::vec4> found =
                         aberrated_colours(shaders, texels, false, pixel_calls(texels, 0, turns));
                     double changed = 0;
                     for (std::size_t i = 0; i < found.size(); ++i) changed += found[i] != texels.colours[i];
                     return Values{changed};
                   },
                   {0});
  for (const float light : {0.0f, 1e-30f, 0.3f, 1e30f})
    for (const double amount : {0.01, 1.0}) {
      const auto words = [=](const char* what) {
        return fmt::format("an even picture of {:g}, an amount of {:g}: {}", light, amount, what);
      };
      const glm::vec3 fill = light * glm::vec3(1, 0.5f, 0.25f);
      group.equals(words("the nearest texels: pixels that change"),
                   [=, &shaders] {
                     const Texels even(20, 10, fill);
                     double changed = 0;
                     for (const glm::vec4& c : aberrated_colours(shaders, even, false, pixel_calls(even, amount, 0.1)))
                       changed += c != glm::vec4(fill, 1);
                     return Values{changed};
                   },
                   {0});
      group.close(words("mixed texels"), {1e-6, "relative", "the weights of texels sum to 1 up to their roundings"},
                  [=, &shaders] {
                    const Texels even(20, 10, fill);
                    double worst = 0;
                    for (const glm::vec4& c : aberrated_colours(shaders, even, true, pixel_calls(even, amount, 0.1)))
                      worst = worse_of(worst, each_relative(values(glm::vec3(c)), values(fill)));
                    return worst;
                  });
    }
  for (const double amount : {1e-3, 0.05, 1.0})
    for (const double turns : {0.0, 0.25, 1.0, 10.0, 1000.0, 1e6}) {
      // The sum, the product and 2 pi, each rounded.
      const double phase = 2 * std::numbers::pi * (turns + 1) * 3 * rounding_unit;
      group.close(
          fmt::format("2000 places, an amount of {:g}, {:g} turns", amount, turns),
          {read_error + 4 * rounding_unit + 0.5 * amount * std::min(phase + 2e-6, 2.0), "of the picture",
           fmt::format("three roundings of so many turns are {:.2g} rad of the phase, which counts amount / 2 "
                       "times; the sine is taken as good to 2e-6; drivers mix the 64 texels a side by weights of "
                       "at least 8 bits",
                       phase)},
          [=, &shaders] { return channel_places_error(shaders, random_calls(amount, turns)); });
    }
  group.close("whole turns more or less, up to 16, an amount of 0.5",
              {2 * read_error + 0.5 * 0.5 * 2 * (2 * std::numbers::pi * 17 * 3 * rounding_unit + 2e-6),
               "of the picture", "as above, twice"},
              [&shaders] {
                const Texels texels = coordinate_texels(0);
                const std::vector<glm::vec4> plain = aberrated_colours(shaders, texels, true, random_calls(0.5, 0.125));
                double worst = 0;
                for (const double turns : {-16.0, -1.0, 1.0, 16.0})
                  worst = worse_of(
                      worst,
                      difference(all_values(aberrated_colours(shaders, texels, true, random_calls(0.5, 0.125 + turns))),
                                 all_values(plain)));
                return worst;
              });
  group.equals("light of 1e30 in one channel of one pixel: other channels that change",
               [&shaders] {
                 Texels texels = random_texels(30, 20, 0, 1);
                 const std::vector<ShaderInput> calls = pixel_calls(texels, 0.1, 0.2);
                 const std::vector<glm::vec4> plain = aberrated_colours(shaders, texels, true, calls);
                 texels.at(20, 5).g = 1e30f;
                 const std::vector<glm::vec4> found = aberrated_colours(shaders, texels, true, calls);
                 double changed = 0;
                 for (std::size_t i = 0; i < found.size(); ++i)
                   changed += found[i].r != plain[i].r || found[i].b != plain[i].b;
                 return Values{changed};
               },
               {0});
}

}  // namespace atelier::stability
