// cut_away: points upon, next to and far from a plane.
#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

void add_cut_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("cut_away (GLSL)");
  const ShaderFunction function{text_including("07-stencil-portals/stencil_portals.glsl"),
                                {"p", "plane"},
                                "vec4(cut_away(p.xyz, plane) ? 1.0 : 0.0)"};
  const auto of = [=, &shaders](glm::vec3 p, glm::vec4 plane) {
    return Values{shaders.number(function, input_of(p, plane))};
  };
  const glm::vec4 at_5(0, 0, 1, -5), behind(0, 0, -1, 5);
  group.equals("on the plane", [=] { return of({1, 2, 5}, at_5); }, {0});
  group.equals("on the plane, from behind", [=] { return of({1, 2, 5}, behind); }, {0});
  group.equals("one float before it", [=] { return of({1, 2, std::nextafter(5.0f, 0.0f)}, at_5); }, {1});
  group.equals("one float beyond it", [=] { return of({1, 2, std::nextafter(5.0f, 9.0f)}, at_5); }, {0});
  group.equals("one float beyond it, from behind", [=] { return of({1, 2, std::nextafter(5.0f, 9.0f)}, behind); }, {1});
  group.equals("1e30 m along the plane", [=] { return of({1e30f, -1e30f, 4}, at_5); }, {1});
  group.equals("1e30 m before and beyond",
               [=] {
                 return Values{of({0, 0, -1e30f}, at_5)[0], of({0, 0, 1e30f}, at_5)[0]};
               },
               {1, 0});
  group.equals("all is on the seen side of no plane, or on the other",
               [=] {
                 return Values{of({3, 4, 5}, {0, 0, 0, 1})[0], of({3, 4, 5}, {0, 0, 0, -1})[0]};
               },
               {0, 1});
  group.equals("on a plane a million metres away", [=] { return of({1e6f, 7, 8}, {-1, 0, 0, 1e6f}); }, {0});
  for (const double size : {1.0, million})
    group.equals(fmt::format("2000 points and planes within {:g} m, but those that rounding decides: wrong", size),
                 [=, &shaders] {
                   std::vector<ShaderInput> inputs;
                   Values expected;
                   for (int i = 0; i < 2000; ++i) {
                     Trial t(780, i);
                     const glm::vec4 plane(glm::dvec4(t.direction(), size * t.between(-1, 1)));
                     const glm::vec3 p(t.in_cube(size));
                     const double distance = glm::dot(glm::dvec4(plane), glm::dvec4(p, 1));
                     if (std::abs(distance) < 16 * rounding_unit * size) continue;
                     inputs.push_back(input_of(p, plane));
                     expected.push_back(distance < 0 ? 1 : 0);
                   }
                   return Values{difference(shaders.numbers(function, inputs), expected)};
                 },
                 {0});
}

}  // namespace atelier::stability
