// Step @NUMBER@'s table of extremes.
#include "@STEP@/@NAME@.hpp"
#include "stability/entry.hpp"
#include "stability/rows.hpp"

namespace atelier::stability {

namespace {

void add_density_rows(Table& table) {
  Group group = table.of("density");
  const auto of = [](float half_distance) { return Values{@NAME@::density(half_distance)}; };
  for (const float bad : {0.0f, -1.0f, -infinite, not_a_number})
    group.refuses("a distance that is not above 0", [=] { of(bad); });
  group.equals("infinity", [=] { return of(infinite); }, {0});
  group.same("below a millionth of a metre", [=] { return of(denormal); }, [=] { return of(1e-6f); });
  for (const float half : {1e-6f, 1.0f, 1e6f})
    group.close("half of the light is left", {2 * rounding_unit, "relative", "a constant and a quotient"}, [=] {
      return relative_difference(of(half), {std::log(2.0) / double(half)});
    });
}

void add_light_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("@NAME@_light (GLSL)");
  const ShaderFunction function{text_including("@STEP@/@NAME@.glsl"),
                                {"light", "air", "by"},
                                "vec4(@NAME@_light(light.rgb, air.rgb, by.x, by.y, int(by.z)), 0.0)"};
  const glm::vec3 light(1, 0.5f, 0), air(0.25f, 0, 1);
  const auto of = [=, &shaders](float density, float way, float pieces) {
    return values(glm::vec3(shaders.evaluate(function, input_of(light, air, glm::vec3(density, way, pieces)))));
  };
  group.equals("distance 0", [=] { return of(1, 0, 0); }, {1, 0.5, 0});
  group.equals("density 0, 1e30 m", [=] { return of(0, 1e30f, 0); }, {1, 0.5, 0});
  group.equals("1e30 m of fog", [=] { return of(1, 1e30f, 0); }, {0.25, 0, 1});
  group.equals("1e30 m of fog in one piece", [=] { return of(1, 1e30f, 1); }, {0.25, 0, 1});
  group.finite("a product of density and distance that overflows", [=] { return of(1e30f, 1e30f, 4); });
  for (const float way : {1e-6f, 0.1f, 1.0f, 10.0f})
    group.close("the exponential", {4e-6, "absolute", "the driver's exponential: some ulp of numbers up to 1"},
                [=] {
                  const double through = std::exp(-double(way));
                  return difference(of(1, way, 0), {0.25 + 0.75 * through, 0.5 * through, 1 - through});
                });
}

}  // namespace

}  // namespace atelier::stability

void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders) {
  using namespace atelier::stability;
  add_density_rows(table);
  add_light_rows(table, shaders);
}
