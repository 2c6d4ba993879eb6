// balance, power_table, specular_normalisation: no surface gives back more than it got.
#include "stability/02-blinn-phong/rows.hpp"

namespace atelier::stability {

using blinn_phong::balance;
using blinn_phong::power_table;

namespace {

struct Pair {
  glm::vec3 diffuse, specular;
};
Pair balanced(glm::vec3 diffuse, glm::vec3 specular) {
  balance(diffuse, specular);
  return {diffuse, specular};
}
Values values_of(const Pair& p) {
  return {p.diffuse.r, p.diffuse.g, p.diffuse.b, p.specular.r, p.specular.g, p.specular.b};
}
double largest_sum(const Pair& p) {
  const glm::dvec3 sum = glm::dvec3(p.diffuse) + glm::dvec3(p.specular);
  return std::max({sum.r, sum.g, sum.b});
}

void add_balance_rows(Table& table) {
  Group group = table.of("balance");
  const Bound one{2 * rounding_unit, "above one", "each colour is divided and rounded once"};
  group.equals(
      "black",
      [] {
        return values_of(balanced({0, 0, 0}, {0, 0, 0}));
      },
      Values(6, 0));
  group.equals("a sum of exactly one stays",
               [] {
                 return values_of(balanced({0.5f, 0.25f, 0}, {0.5f, 0.75f, 1}));
               },
               {0.5, 0.25, 0, 0.5, 0.75, 1});
  group.equals(
      "denormal colours stay", [] { return values_of(balanced(glm::vec3(denormal), glm::vec3(denormal))); },
      Values(6, double(denormal)));
  for (const float size : {1.0000001f, 2.0f, 1e6f, 1e30f, 1e38f})
    group.close(fmt::format("colours of {:g}", size), one, [=] {
      const double sum = largest_sum(balanced(size * glm::vec3(1, 0.5f, 0.25f), size * glm::vec3(1, 0.1f, 0)));
      return std::abs(sum - 1);
    });
  group.close(
      "one component of 1e6 beside 1e-6: the hue stays", {2 * rounding_unit, "relative", "a quotient each"}, [] {
        const Pair p = balanced({1e6f, 1e-6f, 0}, {0, 0, 1e3f});
        return each_relative({p.diffuse.g / p.diffuse.r, p.specular.b / p.diffuse.r}, {double(1e-6f) / 1e6, 1e-3});
      });
  group.close("3000 random materials: at most one", one, [] {
    return worst_of(3000, 100, [](Trial& t) {
      const float size = float(t.size_between(0.1, 100));
      const auto colour = [&] { return size * glm::vec3(t.between(0, 1), t.between(0, 1), t.between(0, 1)); };
      const glm::vec3 diffuse = colour(), specular = colour();
      return std::max(0.0, largest_sum(balanced(diffuse, specular)) - 1);
    });
  });
  group.close("3000 random materials: one common factor, never above one",
              {4 * rounding_unit, "relative", "the sum and the quotient are rounded, and so is what is expected"}, [] {
                return worst_of(3000, 101, [](Trial& t) {
                  const glm::vec3 diffuse(t.between(0.1, 2), t.between(0.1, 2), t.between(0.1, 2));
                  const glm::vec3 specular(t.between(0.1, 2), t.between(0.1, 2), t.between(0.1, 2));
                  const Pair p = balanced(diffuse, specular);
                  const double factor = std::min(1.0, 1 / largest_sum({diffuse, specular}));
                  return relative_difference(values_of(p), values_of({glm::vec3(glm::dvec3(diffuse) * factor),
                                                                      glm::vec3(glm::dvec3(specular) * factor)}));
                });
              });
}

void add_cone_cosine_rows(Table& table) {
  Group group = table.of("cone_cosines");
  const float pi = std::numbers::pi_v<float>;
  const auto cosines = [](float inner, float outer) { return values(blinn_phong::cone_cosines(inner, outer)); };
  group.equals("a cone of 0", [=] { return cosines(0, 0); }, {1, 1});
  group.equals("a cone of 180 degrees to each side", [=] { return cosines(pi, pi); }, {-1, -1});
  group.equals("a cone of a double's pi, rounded", [=] { return cosines(0, float(std::numbers::pi)); }, {1, -1});
  group.equals("equal angles give equal cosines, 1000 of them",
               [=] {
                 double different = 0;
                 for (int i = 0; i < 1000; ++i) {
                   const Values c = cosines(pi * float(i) / 999, pi * float(i) / 999);
                   different += c[0] != c[1];
                 }
                 return Values{different};
               },
               {0});
  group.equals("never outside -1 to 1, and never rising, 4096 angles",
               [=] {
                 double wrong = 0, before = 1;
                 for (int i = 0; i <= 4096; ++i) {
                   const double c = cosines(0, pi * float(i) / 4096)[1];
                   wrong += !(c <= before && c >= -1);
                   before = c;
                 }
                 return Values{wrong};
               },
               {0});
  group.close("angles of 1e-4, 90 and 179.9 degrees", {2 * rounding_unit, "absolute", "the cosine of a float, rounded"},
              [=] {
                const float angles[] = {1e-4f, pi / 2, 179.9f * pi / 180};
                Values actual, expected;
                for (const float angle : angles) {
                  actual.push_back(cosines(0, angle)[1]);
                  expected.push_back(std::cos(double(angle)));
                }
                return difference(actual, expected);
              });
}

void add_power_table_rows(Table& table) {
  Group group = table.of("power_table");
  group.refuses("a size of 1", [] { power_table(1, 1); });
  group.refuses("a size of 0", [] { power_table(1, 0); });
  group.refuses("a negative size", [] { power_table(1, -5); });
  group.refuses("a negative exponent", [] { power_table(-1, 16); });
  group.refuses("an exponent of NaN", [] { power_table(not_a_number, 16); });
  const auto table_of = [](float exponent, int size) {
    const std::vector<float> made = power_table(exponent, size);
    return Values(made.begin(), made.end());
  };
  group.equals("two entries", [=] { return table_of(7, 2); }, {0, 1});
  group.equals("an exponent of 0: ones, at 0 too", [=] { return table_of(0, 5); }, {1, 1, 1, 1, 1});
  group.equals("an exponent of 1e6: nothing but the last", [=] { return table_of(1e6f, 5); }, {0, 0, 0, 0, 1});
  for (const float exponent : {1e-6f, 1.0f, 1e3f, 1e6f})
    group.close(fmt::format("an exponent of {:g}, 4096 entries", exponent),
                {rounding_unit + 1e-9, "relative", "a double power, rounded once; below 1e-38 absolute"}, [=] {
                  const Values made = table_of(exponent, 4096);
                  double worst = 0;
                  for (std::size_t i = 1; i < made.size(); ++i) {
                    const double exact = std::exp(double(exponent) * std::log(double(i) / 4095));
                    if (exact > 1e-37) worst = std::max(worst, std::abs(made[i] - exact) / exact);
                  }
                  return worst;
                });
}

/// What a white highlight of exponent n reflects of light from the eye's side, N = V, without its factor: the integral
/// of (N.H)^n (N.L) / pi over the hemisphere of L. The half vector has half of L's angle; with its cosine c, N.L is
/// 2 c^2 - 1 and the solid angle 8 pi c dc, for c from cos 45 degrees to 1. Midpoint rule over the logarithm of 1 - c,
/// since a large n gathers all of it there.
double albedo_without_normalisation(double n) {
  constexpr int steps = 200'000;
  const double low = std::log(1e-12), high = std::log(1 - std::sqrt(0.5));
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double u = std::exp(low + (high - low) * (i + 0.5) / steps), c = 1 - u;
    sum += std::exp(n * std::log1p(-u)) * (2 * c * c - 1) * 8 * c * u;
  }
  return sum * (high - low) / steps;
}

void add_normalisation_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("specular_normalisation (GLSL)");
  const auto factor = [&shaders](int kind, float exponent) {
    const ShaderFunction function =
        blinn_phong_function({"n"}, "vec4(specular_normalisation(n.x))", {.normalisation = kind});
    return shaders.number(function, input_of(exponent));
  };
  const Bound rounded{1e-6, "relative", "two sums, two products and a quotient; exp2 good to 4 ulp vanishes beside n"};
  group.equals("none: always 1", [=] { return Values{factor(0, 0), factor(0, 1e6f)}; }, {1, 1});
  for (const float n : {0.0f, 1e-3f, 1.0f, 100.0f, 1e6f}) {
    group.close(fmt::format("(n + 8) / 8 at n = {:g}", n), rounded,
                [=] { return std::abs(factor(1, n) - (double(n) + 8) / 8) / ((double(n) + 8) / 8); });
    group.close(fmt::format("exact at n = {:g}", n), rounded, [=] {
      const double exact = (double(n) + 2) * (double(n) + 4) / (8 * (std::exp2(-double(n) / 2) + double(n)));
      return std::abs(factor(2, n) - exact) / exact;
    });
  }
  for (const float n : {0.0f, 1.0f, 8.0f, 100.0f, 1e4f, 1e6f})
    group.close(fmt::format("n = {:g}: a white highlight reflects all that arrives straight on", n),
                {2e-6, "relative", "the factor's own 1e-6, and the quadrature's 1e-9"},
                [=] { return std::abs(factor(2, n) * albedo_without_normalisation(double(n)) - 1); });
}

}  // namespace

void add_energy_rows(Table& table, ShaderFunctions& shaders) {
  add_balance_rows(table);
  add_cone_cosine_rows(table);
  add_power_table_rows(table);
  add_normalisation_rows(table, shaders);
}

}  // namespace atelier::stability
