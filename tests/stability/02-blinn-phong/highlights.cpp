// highlight: (N.H)^n by pow, by the stable form and by the table, at exponents of 0 to a million.
//
// The truth is exp(n/2 log1p(-s)) in double precision, with s the squared sine between the two vectors as the floats
// have them: so the error is the function's alone, and not that of vectors which cannot be rounded any better.
#include "stability/02-blinn-phong/rows.hpp"

namespace atelier::stability {

namespace {

enum Power { by_pow, stable, by_table };

ShaderFunction highlight_function(Power power) {
  return blinn_phong_function({"normal", "half_vector", "n"}, "vec4(highlight(normal.xyz, half_vector.xyz, n.x))",
                              {.power = int(power)});
}

/// Two unit vectors at an angle, turned at random, and rounded to floats.
struct UnitPair {
  glm::vec3 normal, half_vector;
};
UnitPair unit_pair(Trial& t, double angle) {
  const glm::dvec3 normal = t.direction();
  const glm::dvec3 aside = glm::normalize(glm::cross(normal, t.direction()));
  return {glm::vec3(normal), glm::vec3(std::cos(angle) * normal + std::sin(angle) * aside)};
}

double exact_highlight(const UnitPair& pair, double exponent) {
  const glm::dvec3 n = glm::normalize(glm::dvec3(pair.normal)), h = glm::normalize(glm::dvec3(pair.half_vector));
  if (exponent == 0) return 1;
  if (glm::dot(n, h) <= 0) return 0;
  const glm::dvec3 sine = glm::cross(n, h);
  return std::exp(exponent / 2 * std::log1p(-std::min(1.0, glm::dot(sine, sine))));
}

/// The largest absolute error over 256 pairs whose highlight is about `height` of its peak.
double highlight_error(ShaderFunctions& shaders, Power power, double exponent, double height,
                       const std::map<std::string, GLuint>& textures = {}) {
  const double angle = std::acos(std::min(1.0, std::pow(height, 1 / exponent)));
  std::vector<UnitPair> pairs;
  std::vector<ShaderInput> inputs;
  for (int i = 0; i < 256; ++i) {
    Trial t(130, i);
    pairs.push_back(unit_pair(t, angle));
    inputs.push_back(input_of(pairs.back().normal, pairs.back().half_vector, float(exponent)));
  }
  ShaderFunction function = highlight_function(power);
  function.textures = textures;
  const std::vector<glm::vec4> results = shaders.evaluate(function, inputs);
  double worst = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double error = std::abs(double(results[i].x) - exact_highlight(pairs[i], exponent));
    if (!(error <= worst)) worst = std::isnan(error) ? double(infinite) : error;
  }
  return worst;
}

double single(ShaderFunctions& shaders, Power power, const glm::vec3& normal, const glm::vec3& half_vector, float n) {
  return shaders.number(highlight_function(power), input_of(normal, half_vector, n));
}

Sweep exponent_sweep(ShaderFunctions& shaders) {
  Sweep sweep{.name = "highlight",
              .title = "The highlight at half its height, in 32-bit floats",
              .x_label = "exponent n",
              .y_label = "largest error of 256 directions (the peak is 1)",
              .curves = {{"pow of the cosine", {}}, {"stable: from the sine", {}}}};
  for (int step = 0; step <= 24; ++step) {
    const double n = std::pow(10.0, step / 4.0);
    sweep.curves[0].points.push_back({n, highlight_error(shaders, by_pow, n, 0.5)});
    sweep.curves[1].points.push_back({n, highlight_error(shaders, stable, n, 0.5)});
  }
  return sweep;
}

Bound stable_bound(double n, double height) {
  // A sine of sqrt(1/n) is a difference of products near 1, so a rounding of it counts sqrt(n) times. Far from the peak
  // the function takes the logarithm of 1 - s, a small squared cosine that is eight roundings of 1 off: s is the sum of
  // three squares of differences of products.
  const double squared_cosine = std::pow(height, 2 / n);
  const double far_off = squared_cosine < 0.99 ? 8 * rounding_unit * n / 2 * height / squared_cosine : 0;
  return {
      1.5e-6 + 14 * rounding_unit * std::sqrt(n) + far_off, "of the peak",
      "a rounding of the sine counts sqrt(n) times; where the cosine is small, one of its square n/2 times over it"};
}

/// Rows that both forms share.
void add_common_rows(Group& group, ShaderFunctions& shaders, Power power) {
  const glm::vec3 up(0, 1, 0), side(1, 0, 0);
  const auto at = [&shaders, power](const glm::vec3& n, const glm::vec3& h, float exponent) {
    return single(shaders, power, n, h, exponent);
  };
  group.equals("an exponent of 0: 1 everywhere, below the horizon too",
               [=] {
                 return Values{at(up, up, 0), at(up, side, 0), at(up, -up, 0)};
               },
               {1, 1, 1});
  group.equals("N = H at every exponent to 1e6",
               [=] {
                 return Values{at(up, up, 1e-6f), at(up, up, 1), at(up, up, 1e3f), at(up, up, 1e6f)};
               },
               {1, 1, 1, 1});
  group.equals("a half vector square to the normal",
               [=] {
                 return Values{at(up, side, 1), at(up, side, 1e6f)};
               },
               {0, 0});
  group.equals("a half vector behind: 0, not the mirror image",
               [=] {
                 return Values{at(up, -up, 1), at(up, -up, 2), at(up, -up, 1e6f)};
               },
               {0, 0, 0});
  group.equals("no normal, no half vector: 0", [=] { return Values{at({}, up, 5), at(up, {}, 5)}; }, {0, 0});
  group.close("N and H exchanged: the same, 300 random pairs at n = 50",
              {4 * rounding_unit * 50, "absolute",
               "the same products in another order; a rounding of the cosine counts n times"},
              [=] {
                return worst_of(300, 131, [&](Trial& t) {
                  const UnitPair p = unit_pair(t, t.between(0, 1));
                  return std::abs(at(p.normal, p.half_vector, 50) - at(p.half_vector, p.normal, 50));
                });
              });
}

void add_table_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("highlight, from the table (GLSL)");
  /// Error with the table of an exponent, `size` entries.
  const auto error = [&shaders](float exponent, int size, double height) {
    Image row(size, 1);
    const std::vector<float> entries = blinn_phong::power_table(exponent, size);
    for (int x = 0; x < size; ++x) row.at(x, 0).r = entries[std::size_t(x)];
    const GlTexture texture(shaders.gl(), blinn_phong::upload_texture(shaders.gl(), std::vector<Image>{row},
                                                                      Wrap::clamp_to_edge, Filter::linear));
    return highlight_error(shaders, by_table, exponent, height, {{"u_power_table", texture.id()}});
  };
  for (const float n : {8.0f, 64.0f, 512.0f})
    group.close(fmt::format("n = {:g} in 4096 entries, at half height", n),
                {n * n / (8 * 4095.0 * 4095.0) + n * 8 * rounding_unit + 4e-3 * n / 4095 / 2, "absolute",
                 "a chord over a curve is h^2/8 of its second derivative off, n^2 at most; drivers place a sample to "
                 "1/256 of a texel, which counts n/2 at half height"},
                [=] { return error(n, 4096, 0.5); });
  group.close("n = 0.5: the slope is infinite at 0",
              {0.5 / 64, "absolute", "sqrt(1/4095), the first entry; at half height far less"},
              [=] { return error(0.5f, 4096, 0.5); });
  group.equals("N = H reads the last entry, 1, of 2, 3 and 4096",
               [&shaders] {
                 Values out;
                 for (const int size : {2, 3, 4096}) {
                   Image row(size, 1);
                   row.at(size - 1, 0).r = 1;
                   const GlTexture texture(shaders.gl(),
                                           blinn_phong::upload_texture(shaders.gl(), std::vector<Image>{row},
                                                                       Wrap::clamp_to_edge, Filter::linear));
                   ShaderFunction function = highlight_function(by_table);
                   function.textures = {{"u_power_table", texture.id()}};
                   out.push_back(shaders.number(function, input_of(glm::vec3(0, 1, 0), glm::vec3(0, 1, 0), 7.0f)));
                 }
                 return out;
               },
               {1, 1, 1});
}

}  // namespace

void add_highlight_rows(Table& table, ShaderFunctions& shaders) {
  Group power = table.of("highlight, by pow (GLSL)"), from_sine = table.of("highlight, stable (GLSL)");
  add_common_rows(power, shaders, by_pow);
  add_common_rows(from_sine, shaders, stable);
  for (const double n : {1.0, 1e2, 1e3, 1e4, 1e5, 1e6})
    power.close(
        fmt::format("n = {:g} at half height", n),
        {(4 * n + 16) * rounding_unit, "of the peak",
         "a cosine near 1 is three to eight roundings off, which count n times and half as much at half height"},
        [=, &shaders] { return highlight_error(shaders, by_pow, n, 0.5); });
  for (const double n : {1.0, 1e2, 1e3, 1e4, 1e5, 1e6})
    for (const double height : {0.99, 0.5, 1e-3})
      from_sine.close(fmt::format("n = {:g} at {:g} of the peak", n, height), stable_bound(n, height),
                      [=, &shaders] { return highlight_error(shaders, stable, n, height); });
  from_sine.close("where series and logarithm meet, s = 0.01, n = 100",
                  {2e-5, "of the peak",
                   "the first term left out, n/2 s^5/5, is 1e-9; the logarithm of 0.99 keeps 7 digits of 0.01"},
                  [&shaders] { return highlight_error(shaders, stable, 100, std::pow(0.99, 50.0)); });
  add_table_rows(table, shaders);
  table.sweeps.push_back([&shaders] { return exponent_sweep(shaders); });
}

}  // namespace atelier::stability
