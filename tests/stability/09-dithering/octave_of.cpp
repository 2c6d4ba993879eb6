// octave_of: sizes of 1e-30 to 1e30 metres, powers of two and the floats beside them.
#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

namespace {

/// How far x + y is from the logarithm and 1, as a part of the logarithm, which counts as 1 at least; infinite if x is
/// not whole, or y not from 0 to 1.
double octave_error(const ShaderInput& in, const glm::vec4& out) {
  if (out.x != std::round(out.x) || !(out.y >= 0 && out.y <= 1)) return double(INFINITY);
  const double octaves = std::log2(double(in[0].x));
  return std::abs(double(out.x) + double(out.y) - 1 - octaves) / std::max(1.0, std::abs(octaves));
}

/// 2^-99 .. 2^99, moved by so many floats.
std::vector<float> powers_of_two(int floats) {
  std::vector<float> powers;
  for (int k = -99; k <= 99; ++k) {
    float size = std::ldexp(1.0f, k);
    for (int i = 0; i < std::abs(floats); ++i) size = std::nextafter(size, floats < 0 ? 0.0f : largest_float);
    powers.push_back(size);
  }
  return powers;
}

}  // namespace

void add_octave_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("octave_of (GLSL)");
  const ShaderFunction function = dither_function({"size"}, "vec4(octave_of(size.x), 0.0, 0.0)");
  const auto octaves_at = [=, &shaders](const std::vector<float>& sizes) {
    std::vector<ShaderInput> calls;
    for (const float size : sizes) calls.push_back(input_of(size));
    std::vector<glm::vec2> octaves;
    for (const glm::vec4& v : shaders.evaluate(function, calls)) octaves.emplace_back(v);
    return octaves;
  };
  const Bound bound{10 * rounding_unit, "of the logarithm, at least 1",
                    "drivers' logarithm is good to 3 of its last places or 2^-21, as later GLSL demands, and the "
                    "fraction is rounded"};
  group.close("0.3 m", {1e-3, "absolute", "the contract's number has three digits"}, [=] {
    return difference(all_values(octaves_at({0.3f})), {-1, 0.263});
  });
  group.equals("2^-99 m to 2^99 m: those whose cells are not two pixels wide",
               [=] {
                 const std::vector<glm::vec2> octaves = octaves_at(powers_of_two(0));
                 double wrong = 0;
                 for (int k = -99; k <= 99; ++k) wrong += octaves[std::size_t(k + 99)] != glm::vec2(k + 1, 0);
                 return Values{wrong};
               },
               {0});
  for (const int floats : {-2, -1, 1, 2})
    group.close(fmt::format("2^-99 m to 2^99 m, moved by {} floats", floats), bound, [=, &shaders] {
      double worst = 0;
      for (const float size : powers_of_two(floats)) {
        const ShaderInput in = input_of(size);
        worst = worse_of(worst, octave_error(in, shaders.evaluate(function, in)));
      }
      return worst;
    });
  for (const auto& [low, high] : {std::pair{1e-30, 1e30}, {1e-4, 1e3}, {0.5, 2.0}, {0.9999, 1.0001}})
    group.close(fmt::format("10000 random sizes, {:g} m to {:g} m", low, high), bound,
                [=, &shaders, low = low, high = high] {
                  return worst_of_calls(
                      shaders, function, 10'000, 1020,
                      [=](Trial& t) { return input_of(float(t.size_between(low, high))); }, octave_error);
                });
  for (const auto& [low, high] : {std::pair{1e-30, 1e30}, {1e-4, 1e3}, {0.9999, 1.0001}})
    group.close(fmt::format("10000 sizes that grow from {:g} m to {:g} m: by how much x + y falls", low, high), bound,
                [=, low = low, high = high] {
                  std::vector<float> sizes;
                  for (int i = 0; i < 10'000; ++i)
                    sizes.push_back(float(low * std::exp(std::log(high / low) * i / 10'000)));
                  const std::vector<glm::vec2> octaves = octaves_at(sizes);
                  double fall = 0;
                  for (std::size_t i = 1; i < sizes.size(); ++i) {
                    const glm::dvec2 before(octaves[i - 1]), here(octaves[i]);
                    const double size = std::max(1.0, std::abs(std::log2(double(sizes[i]))));
                    fall = worse_of(fall, (before.x + before.y - here.x - here.y) / size);
                  }
                  return fall;
                });
  group.close("1000 random sizes, twice as large: x + y grows by 1",
              {2 * 100 * bound.value, "octaves", "two logarithms of up to 100, with the bound of the others each"},
              [=] {
                std::vector<float> sizes, doubled;
                for (int i = 0; i < 1000; ++i) {
                  sizes.push_back(float(Trial(1021, i).size_between(1e-30, 1e30)));
                  doubled.push_back(2 * sizes.back());
                }
                const std::vector<glm::vec2> small = octaves_at(sizes), large = octaves_at(doubled);
                double worst = 0;
                for (std::size_t i = 0; i < sizes.size(); ++i) {
                  const glm::dvec2 grown = glm::dvec2(large[i]) - glm::dvec2(small[i]);
                  worst = worse_of(worst, std::abs(grown.x + grown.y - 1));
                }
                return worst;
              });
  add_nan_row(group, shaders, function, input_of(0.3f));
}

}  // namespace atelier::stability
