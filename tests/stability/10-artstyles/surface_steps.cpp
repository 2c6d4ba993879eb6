// surface_steps: nothing seen, one pixel seen, planes near and far and steep, depths a million times apart, normals
// that are opposite or nearly alike.
#include "stability/10-artstyles/rows.hpp"

namespace atelier::stability {

namespace {

using Around = std::array<glm::vec4, 9>;

ShaderInput steps_call(const Around& around) {
  return {around.begin(), around.end()};
}

/// In double precision: pairs by the offset of one of them, and over differences.
glm::dvec2 exact_steps(const ShaderInput& around) {
  glm::dvec2 most(0);
  const glm::dvec4 here(around[4]);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const glm::dvec4 a(around[std::size_t(4 + 3 * dy + dx)]), b(around[std::size_t(4 - 3 * dy - dx)]);
      const double nearest = std::max({a.w, b.w, here.w});
      if (nearest > 0) most.x = std::max(most.x, std::abs((a.w - here.w) + (b.w - here.w)) / nearest);
      most.y = std::max(most.y, glm::length(glm::dvec3(a) - glm::dvec3(here)));
    }
  return most;
}

double steps_error(const ShaderInput& in, const glm::vec4& out) {
  return difference(values(glm::vec2(out)), values(exact_steps(in)));
}

/// Nine times one normal; 1/depth is `middle` in the middle, and changes by `change.x` a column and `change.y` a row.
Around plane(const glm::vec3& normal, double middle, const glm::dvec2& change) {
  Around around;
  for (int i = 0; i < 9; ++i)
    around[std::size_t(i)] = glm::vec4(normal, middle + change.x * (i % 3 - 1) + change.y * (i / 3 - 1));
  return around;
}

/// A plane of which all nine pixels are seen, as steep as that allows up to a share of `steepest`.
Around random_plane(Trial& t, double middle, double steepest) {
  const double part = t.between(-1, 1), sign = t.sign();
  const glm::dvec2 change = middle * steepest * glm::dvec2(part, sign * (1 - std::abs(part)));
  return plane(glm::vec3(t.direction()), middle, change);
}

void add_depth_rows(Group& group, ShaderFunctions& shaders, const ShaderFunction& function) {
  const Bound plane_bound{10 * rounding_unit, "of the nearest",
                          "the three numbers are rounded, one of them counts twice, and so are their sums, of up to "
                          "twice the largest"};
  for (const double middle : {1e-6, 1e-3, 1.0, 1e3, 1e6})
    for (const double steepest : {0.0, 1e-3, 0.5, 0.99, 0.999999})
      group.close(fmt::format("1000 planes of {:g} 1/m in the middle, that change by up to {:g} of it a pixel: no step",
                              middle, steepest),
                  plane_bound, [=, &shaders] {
                    return worst_of_calls(
                        shaders, function, 1000, 1120,
                        [=](Trial& t) { return steps_call(random_plane(t, middle, steepest)); },
                        [](const ShaderInput&, const glm::vec4& out) { return double(std::max(out.x, out.y)); });
                  });
  for (const float w : {1e-30f, 1e-6f, 1.0f, 1e6f, 1e30f})
    for (int i = 0; i < 9; ++i)
      group.close(fmt::format("pixel {} alone is seen, {:g} 1/m", i, w),
                  {6 * rounding_unit, "absolute", "a quotient of drivers of up to 2, and a length of 1"},
                  [=, &shaders] {
                    Around around{};
                    around[std::size_t(i)] = glm::vec4(0, 0, 1, w);
                    const glm::vec4 found = shaders.evaluate(function, steps_call(around));
                    return difference(values(glm::vec2(found)), {i == 4 ? 2.0 : 1.0, 1});
                  });
  const Bound steps_bound{8 * rounding_unit, "absolute",
                          "of up to 2: two sums of up to twice the nearest, a quotient of drivers, a length"};
  for (const double ratio : {2.0, 1e3, 1e6})
    group.close(fmt::format("10000 random surroundings, depths up to {:g} times apart, some pixels not seen", ratio),
                steps_bound, [=, &shaders] {
                  return worst_of_calls(
                      shaders, function, 10'000, 1121,
                      [=](Trial& t) {
                        Around around{};
                        for (glm::vec4& pixel : around)
                          if (t.between(0, 1) < 0.8) {
                            const glm::vec3 normal(t.direction());
                            pixel = glm::vec4(normal, t.size_between(1 / ratio, 1));
                          }
                        return steps_call(around);
                      },
                      steps_error);
                });
  for (int exponent : {-60, -20, 20, 60})
    group.close(fmt::format("1/depth times 2^{}: the same step", exponent),
                {6 * rounding_unit, "absolute", "a quotient of drivers of up to 2"}, [=, &shaders] {
                  Around around{};
                  for (int i = 0; i < 9; ++i) around[std::size_t(i)].w = float(1 + i * i % 5);
                  const glm::vec4 plain = shaders.evaluate(function, steps_call(around));
                  for (glm::vec4& pixel : around) pixel.w = std::ldexp(pixel.w, exponent);
                  return difference(values(shaders.evaluate(function, steps_call(around))), values(plain));
                });
}

void add_normal_rows(Group& group, ShaderFunctions& shaders, const ShaderFunction& function) {
  const Bound bound{8 * rounding_unit, "absolute", "of up to 2: three differences and a length"};
  for (const double degrees : {0.0, 1e-4, 0.1, 90.0, 180.0})
    for (int i = 0; i < 9; ++i)
      if (i != 4)
        group.close(fmt::format("the normal of pixel {} is {:g} degrees from the others", i, degrees), bound,
                    [=, &shaders] {
                      Around around = plane({0, 0, 1}, 1, {0, 0});
                      const double angle = degrees * std::numbers::pi / 180;
                      around[std::size_t(i)] = glm::vec4(std::sin(angle), 0, std::cos(angle), 1);
                      const ShaderInput in = steps_call(around);
                      return steps_error(in, shaders.evaluate(function, in));
                    });
}

}  // namespace

void add_steps_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("surface_steps (GLSL)");
  std::vector<std::string> parameters;
  std::string list;
  for (int i = 0; i < 9; ++i) {
    parameters.push_back(fmt::format("p{}", i));
    list += (i > 0 ? ", " : "") + parameters.back();
  }
  const ShaderFunction function =
      style_function(parameters, fmt::format("vec4(surface_steps(vec4[9]({})), 0.0, 0.0)", list));
  group.equals("nothing is seen", [=, &shaders] { return values(shaders.evaluate(function, steps_call(Around{}))); },
               {0, 0, 0, 0});
  add_depth_rows(group, shaders, function);
  add_normal_rows(group, shaders, function);
  add_nan_row(group, shaders, function, steps_call(plane({0, 0, 1}, 1, {0.1, 0.2})));
}

}  // namespace atelier::stability
