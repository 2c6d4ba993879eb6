// reflected: no half vector, no normal, grazing light, colours above one; what energy it gives back.
#include "stability/02-blinn-phong/rows.hpp"

namespace atelier::stability {

namespace {

struct Surface {
  glm::vec3 diffuse{0.5f}, specular{0.5f};
  float exponent = 32;
};

ShaderFunction reflected_function(const Variant& variant) {
  return blinn_phong_function({"normal", "eye", "light", "kd", "ks"},
                              "vec4(reflected(normal.xyz, eye.xyz, light.xyz, Material(kd.rgb, ks.rgb, ks.a)), 0.0)",
                              variant);
}

ShaderInput input(const glm::vec3& normal, const glm::vec3& to_eye, const glm::vec3& to_light, const Surface& s) {
  return input_of(normal, to_eye, to_light, s.diffuse, glm::vec4(s.specular, s.exponent));
}

/// In double precision, with the angle of the half vector from the cosine of the doubled angle where the contract has
/// a normalised sum.
glm::dvec3 exact_reflected(const glm::dvec3& n, const glm::dvec3& v, const glm::dvec3& l, const Surface& s) {
  const double n_dot_l = glm::dot(n, l);
  if (n_dot_l <= 0) return glm::dvec3(0);
  const double n_dot_h = (n_dot_l + glm::dot(n, v)) / std::sqrt(2 + 2 * glm::dot(l, v));
  const double lobe = s.exponent == 0 ? 1 : std::pow(std::max(0.0, n_dot_h), double(s.exponent));
  return (glm::dvec3(s.diffuse) + glm::dvec3(s.specular) * lobe) * n_dot_l;
}

/// Share of the light from `to_eye`'s mirror world that comes back over all directions: the integral of `reflected`
/// over the hemisphere of L, over pi, on an even grid of the unit disc (Malley: dw N.L is the disc's area), where N.L
/// is divided out. 128 x 128 points.
double albedo(ShaderFunctions& shaders, double angle_of_eye, const Surface& surface, const Variant& variant) {
  const glm::vec3 normal(0, 0, 1), to_eye(std::sin(angle_of_eye), 0, std::cos(angle_of_eye));
  std::vector<ShaderInput> inputs;
  std::vector<double> cosines;
  for (int ring = 0; ring < 128; ++ring)
    for (int turn = 0; turn < 128; ++turn) {
      const double r = std::sqrt((ring + 0.5) / 128), phi = 2 * std::numbers::pi * (turn + 0.5) / 128;
      cosines.push_back(std::sqrt(1 - r * r));
      inputs.push_back(input(normal, to_eye, {r * std::cos(phi), r * std::sin(phi), cosines.back()}, surface));
    }
  const std::vector<glm::vec4> results = shaders.evaluate(reflected_function(variant), inputs);
  double sum = 0;
  for (std::size_t i = 0; i < results.size(); ++i) sum += double(results[i].r) / cosines[i];
  return sum / double(results.size());
}

void add_degenerate_rows(Group& group, ShaderFunctions& shaders) {
  const glm::vec3 up(0, 1, 0);
  const auto red = [&shaders](const glm::vec3& n, const glm::vec3& v, const glm::vec3& l, const Surface& s,
                              const Variant& variant = {}) {
    return shaders.number(reflected_function(variant), input(n, v, l, s));
  };
  group.equals("L = -V, the light above: diffuse alone", [=] { return Values{red(up, -up, up, {})}; }, {0.5});
  group.equals("L = -V, the light behind", [=] { return Values{red(up, up, -up, {})}; }, {0});
  for (const float off : {1e-10f, 1e-18f, 1e-20f, 1e-23f, 1e-30f})
    group.equals(fmt::format("L = -V but for {:.0e}: no more than half and half", off),
                 [=] {
                   const double light = red(up, {off, -1, 0}, {off, 1, 0}, {});
                   return Values{double(light >= 0.5 && light <= 1)};  // NaN is neither
                 },
                 {1});
  group.equals("no normal: nothing", [=] { return Values{red({}, up, up, {})}; }, {0});
  group.equals("light from just the horizon", [=] { return Values{red(up, up, {1, 0, 0}, {})}; }, {0});
  group.equals("light from below, the half vector above: no highlight",
               [=] {
                 return Values{red(up, {0, 1, 0}, {0.8f, -0.6f, 0}, {{}, glm::vec3(1), 1})};
               },
               {0});
  group.equals("black", [=] { return Values{red(up, up, up, {glm::vec3(0), glm::vec3(0), 10})}; }, {0});
  group.close("colours of 1e6", {1e-6, "relative", "sums and products, and pow(1, n) = 1"}, [=] {
    return std::abs(red(up, up, up, {glm::vec3(1e6f), glm::vec3(1e6f), 10}) / 2e6 - 1);
  });
  group.equals("an exponent of 0: the highlight is a second diffuse part",
               [=] {
                 return Values{red(up, {1, 0, 0}, up, {glm::vec3(0.25f), glm::vec3(0.5f), 0})};
               },
               {0.75});
  group.equals(
      "ks = 0, with the highlight's code and without: the same",
      [=] {
        const Surface matt{glm::vec3(0.7f), glm::vec3(0), 50};
        const glm::vec3 l(0.6f, 0.8f, 0);
        return Values{red(up, {0, 0.6f, 0.8f}, l, matt) - red(up, {0, 0.6f, 0.8f}, l, matt, {.specular = false})};
      },
      {0});
  for (const int power : {0, 1})
    group.finite(fmt::format("n = 1e6, exact normalisation, grazing light and eye, power {}", power), [=] {
      Values out;
      for (const float height : {1e-7f, 1e-4f, 0.1f})
        for (const float side : {-1.0f, 1.0f})
          out.push_back(red(up, glm::normalize(glm::vec3(side, height, 0)), glm::normalize(glm::vec3(-1, height, 0)),
                            {glm::vec3(0), glm::vec3(1), 1e6f}, {.power = power, .normalisation = 2}));
      return out;
    });
}

void add_property_rows(Group& group, ShaderFunctions& shaders) {
  group.close("2000 random directions, n to 200: against double",
              {200 * 8 * rounding_unit, "absolute", "eight roundings of N.H, which count n times at most"}, [&shaders] {
                std::vector<ShaderInput> inputs;
                Values expected;
                for (int i = 0; i < 2000; ++i) {
                  Trial t(140, i);
                  const glm::vec3 n(t.direction()), v(t.direction()), l(t.direction());
                  const Surface s{glm::vec3(t.between(0, 1)), glm::vec3(t.between(0, 1)), float(t.between(0, 200))};
                  inputs.push_back(input(n, v, l, s));
                  expected.push_back(exact_reflected(n, v, l, s).r);
                }
                Values actual;
                for (const glm::vec4& r : shaders.evaluate(reflected_function({}), inputs))
                  actual.push_back(double(r.r));
                return difference(actual, expected);
              });
  group.close("2000 random directions: eye and light exchanged give the same, N.L apart (Helmholtz)",
              {32 * 16 * rounding_unit, "absolute", "eight roundings of N.H either way, which count n = 32 times"},
              [&shaders] {
                std::vector<ShaderInput> there, back;
                Values there_cosine, back_cosine;
                for (int i = 0; i < 2000; ++i) {
                  Trial t(141, i);
                  const glm::vec3 n(t.direction());
                  glm::vec3 v(t.direction()), l(t.direction());
                  if (glm::dot(v, n) < 0) v = -v;
                  if (glm::dot(l, n) < 0) l = -l;
                  if (std::min(glm::dot(v, n), glm::dot(l, n)) < 0.1f) continue;  // where dividing by N.L costs digits
                  there.push_back(input(n, v, l, {}));
                  back.push_back(input(n, l, v, {}));
                  there_cosine.push_back(glm::dot(glm::dvec3(n), glm::dvec3(l)));
                  back_cosine.push_back(glm::dot(glm::dvec3(n), glm::dvec3(v)));
                }
                const auto a = shaders.evaluate(reflected_function({}), there);
                const auto b = shaders.evaluate(reflected_function({}), back);
                double worst = 0;
                for (std::size_t i = 0; i < a.size(); ++i)
                  worst = std::max(worst, std::abs(double(a[i].r) / there_cosine[i] - double(b[i].r) / back_cosine[i]));
                return worst;
              });
  const Variant exact{.power = 1, .normalisation = 2};
  for (const double degrees : {0.0, 30.0, 60.0, 80.0})
    for (const float n : {1.0f, 8.0f, 100.0f})
      group.close(fmt::format("exact normalisation, n = {:g}, seen {:g} degrees off: gives back at most what arrives",
                              n, degrees),
                  {2e-3, "above one",
                   "16384 points: a lobe of n = 100 covers 300 of them, a midpoint rule good to 1/300 of 1/2"},
                  [=, &shaders] {
                    const double share = albedo(shaders, degrees * std::numbers::pi / 180,
                                                {glm::vec3(0.25f), glm::vec3(0.75f), n}, exact);
                    return std::max(0.0, share - 1);
                  });
  group.close(
      "the usual (n + 8)/8 at n = 8, straight on: 7.5 % too much", {2e-3, "absolute", "the same quadrature"},
      [&shaders] {
        const double share = albedo(shaders, 0, {glm::vec3(0), glm::vec3(1), 8}, {.power = 1, .normalisation = 1});
        return std::abs(share - 16.0 / 8 * (8 * (1.0 / 16 + 8)) / (10 * 12));
      });
}

}  // namespace

void add_reflected_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("reflected (GLSL)");
  add_degenerate_rows(group, shaders);
  add_property_rows(group, shaders);
}

}  // namespace atelier::stability
