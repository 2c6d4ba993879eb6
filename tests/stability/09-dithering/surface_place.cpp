// surface_place: axes, components that are equal or a float apart, positions of any size.
#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

namespace {

/// The components after that of an axis.
glm::vec2 components_after(const glm::vec3& position, int axis) {
  return {position[(axis + 1) % 3], position[(axis + 2) % 3]};
}

/// Whether a place is that of an axis whose component no other exceeds.
double wrong_place(const ShaderInput& in, const glm::vec4& out) {
  const glm::vec3 position(in[0]), size = glm::abs(glm::vec3(in[1]));
  for (int axis = 0; axis < 3; ++axis)
    if (size[axis] >= std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]) &&
        glm::vec2(out) == components_after(position, axis))
      return 0;
  return 1;
}

}  // namespace

void add_surface_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("surface_place (GLSL)");
  const ShaderFunction function =
      dither_function({"position", "normal"}, "vec4(surface_place(position.xyz, normal.xyz), 0.0, 0.0)");
  const auto of = [=, &shaders](const glm::vec3& position, const glm::vec3& normal) {
    return values(glm::vec2(shaders.evaluate(function, input_of(position, normal))));
  };
  for (int axis = 0; axis < 3; ++axis) {
    const auto words = [=](const std::string& what) { return fmt::format("a normal along {}: {}", "xyz"[axis], what); };
    glm::vec3 normal(0);
    normal[axis] = 1;
    for (const float size : {1e-30f, 1.0f, 1e30f}) {
      const glm::vec3 position = size * glm::vec3(1, -2, 3);
      const Values expected = values(components_after(position, axis));
      group.equals(
          words(fmt::format("a position of {:g} m", size)), [=] { return of(position, normal); }, expected);
      group.equals(
          words(fmt::format("a position of {:g} m, seen from behind", size)), [=] { return of(position, -normal); },
          expected);
    }
    glm::vec3 broken(1, -2, 3);
    broken[axis] = not_a_number;
    group.equals(
        words("a NaN in the component left out"), [=] { return of(broken, normal); },
        values(components_after(broken, axis)));
    // A float makes it the largest of three that are equal.
    group.equals(
        words("but for two other components that are a float smaller"),
        [=] {
          glm::vec3 nearly(std::nextafter(0.577350f, 0.0f));
          nearly[axis] = -0.577350f;
          return of({1, -2, 3}, nearly);
        },
        values(components_after({1, -2, 3}, axis)));
    group.equals(words("two others of equal size: places that belong to neither"),
                 [=, &shaders] {
                   glm::vec3 two(0.70710678f);
                   two[axis] = 0;
                   const ShaderInput in = input_of(glm::vec3(1, -2, 3), two);
                   return Values{wrong_place(in, shaders.evaluate(function, in))};
                 },
                 {0});
  }
  group.equals("three equal components, of all signs: places that belong to none",
               [=, &shaders] {
                 double wrong = 0;
                 for (int i = 0; i < 8; ++i) {
                   const glm::vec3 normal(i % 2 == 0 ? 1 : -1, i / 2 % 2 == 0 ? 1 : -1, i / 4 == 0 ? 1 : -1);
                   const ShaderInput in = input_of(glm::vec3(1, -2, 3), 0.577350f * normal);
                   wrong += wrong_place(in, shaders.evaluate(function, in));
                 }
                 return Values{wrong};
               },
               {0});
  group.equals("10000 random normals, positions of 1e-30 to 1e30 m: wrong places",
               [=, &shaders] {
                 return Values{worst_of_calls(
                     shaders, function, 10'000, 1030,
                     [](Trial& t) {
                       const glm::vec3 position(t.size_between(1e-30, 1e30) * t.in_cube(1));
                       return input_of(position, glm::vec3(t.direction()));
                     },
                     wrong_place)};
               },
               {0});
}

}  // namespace atelier::stability
