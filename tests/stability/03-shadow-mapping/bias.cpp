// constant_bias, slope_bias, normal_offset and plane_slope: grazing light, no normal, planes that the light sees edge
// on.
#include "stability/03-shadow-mapping/rows.hpp"

namespace atelier::stability {

namespace {

class Moved {
 public:
  Moved(ShaderFunctions& shaders, std::string call) : shaders_(&shaders), call_(std::move(call)) {}
  Values operator()(const glm::vec3& normal, const glm::vec3& to_light, float amount, const glm::vec3& axis,
                    const glm::vec3& position = {}) const {
    return values(
        glm::vec3(shaders_->evaluate(shadow_function({"p", "n", "l", "a", "amount"}, "vec4(" + call_ + ", 0.0)"),
                                     input_of(position, normal, to_light, axis, amount))));
  }

 private:
  ShaderFunctions* shaders_;
  std::string call_;
};

const glm::vec3 up(0, 1, 0);

void add_constant_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("constant_bias (GLSL)");
  const Moved moved(shaders, "constant_bias(p.xyz, l.xyz, amount.x)");
  group.equals("none", [=] { return moved(up, up, 0, up, {1, 2, 3}); }, {1, 2, 3});
  group.equals("away from the light", [=] { return moved(up, up, -2, up); }, {0, -2, 0});
  group.equals("a light upon the point, which lies no way", [=] { return moved(up, {}, 1, up); }, {0, 0, 0});
  group.equals("1e6 m", [=] { return moved(up, up, 1e6f, up); }, {0, 1e6, 0});
}

void add_slope_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("slope_bias (GLSL)");
  const Moved moved(shaders, "slope_bias(p.xyz, n.xyz, l.xyz, a.xyz, amount.x)");
  group.equals("light straight on: none", [=] { return moved(up, up, 1, up); }, {0, 0, 0});
  group.equals("no normal: none", [=] { return moved({}, up, 1, up); }, {0, 0, 0});
  group.close("light along the floor: cos theta counts as 0.01",
              {2e-6, "relative", "a cross product, a root and a quotient"}, [=] {
                return relative_difference(moved(up, {1, 0, 0}, 1, {1, 0, 0}), {100, 0, 0});
              });
  group.close("light from below: the same", {2e-6, "relative", "a cross product, a root and a quotient"}, [=] {
    return relative_difference(moved(up, slanted(120), 1, {1, 0, 0}), values(100.0 * glm::dvec3(slanted(120))));
  });
  for (const double degrees : {1e-4, 1.0, 45.0, 89.0, 89.4})
    group.close(
        fmt::format("a sun {:g} degrees off: the tangent", degrees),
        {4 * rounding_unit * std::max(1.0, std::tan(degrees * std::numbers::pi / 180)), "relative",
         "a component's rounding over the cosine"},
        [=] {
          const glm::vec3 l = slanted(degrees);
          const double tangent = std::abs(double(l.x)) / double(l.y);
          return std::abs(glm::length(glm::dvec3(moved(up, l, 1, l)[0], moved(up, l, 1, l)[1], 0)) / tangent - 1);
        });
  group.finite("89.9 degrees, a thousand metres", [=] { return moved(up, slanted(89.9), 1000, slanted(89.9)); });
}

void add_normal_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("normal_offset (GLSL)");
  const Moved moved(shaders, "normal_offset(p.xyz, n.xyz, a.xyz, amount.x)");
  group.equals("the map square to the surface's normal: none", [=] { return moved(up, up, 1, up); }, {0, 0, 0});
  group.equals("no normal: none", [=] { return moved({}, up, 1, up); }, {0, 0, 0});
  group.equals("the surface edge on in the map: all of it", [=] { return moved(up, up, 2, {1, 0, 0}); }, {0, 2, 0});
  for (const double degrees : {1e-4, 45.0, 89.9})
    group.close(fmt::format("{:g} degrees: the sine", degrees),
                {4 * rounding_unit, "relative", "a cross product and a root"}, [=] {
                  const glm::vec3 axis = slanted(degrees);
                  return std::abs(moved(up, up, 1, axis)[1] / double(axis.x) - 1);
                });
  group.equals("a surface turned away is moved as far", [=] { return moved(up, -up, 2, {-1, 0, 0}); }, {0, 2, 0});
}

void add_plane_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("plane_slope (GLSL)");
  const auto slope = [&shaders](const glm::vec3& dx, const glm::vec3& dy) {
    const glm::vec4 s = shaders.evaluate(shadow_function({"dx", "dy"}, "vec4(plane_slope(dx.xyz, dy.xyz), 0.0, 0.0)"),
                                         input_of(dx, dy));
    return Values{s.x, s.y};
  };
  const Values none{0, 0};
  group.equals(
      "nothing changes from pixel to pixel", [=] { return slope({}, {}); }, none);
  group.equals(
      "only depth changes: a plane that the light sees edge on",
      [=] {
        return slope({0, 0, 1}, {0, 0, 2});
      },
      none);
  group.equals(
      "both directions are one",
      [=] {
        return slope({1, 2, 3}, {2, 4, 7});
      },
      none);
  group.equals(
      "directions 1e-7 rad apart",
      [=] {
        return slope({1, 0, 1}, {1, 1e-7f, -1});
      },
      none);
  group.equals("directions 1e-5 rad apart: held at 100", [=] { return slope({1, 0, 1}, {1, 1e-5f, -1}); }, {1, -100});
  group.equals("steep both ways", [=] { return slope({1e-3f, 0, 1}, {0, 1e-3f, -1}); }, {100, -100});
  group.equals(
      "steps of 1e-30, whose products are no floats",
      [=] {
        return slope({1e-30f, 0, 1}, {0, 1e-30f, 1});
      },
      none);
  group.close("1000 random planes, pixels a hundredth to a millionth of the map",
              {64 * rounding_unit, "relative, times the sine of the directions' angle",
               "differences of products, over the determinant, which is as small as that sine"},
              [=] {
                return worst_of(1000, 305, [&](Trial& t) {
                  const glm::dvec2 s(t.between(-30, 30), t.between(-30, 30));
                  const double size = t.size_between(1e-6, 1e-2);
                  const auto step = [&] {
                    const glm::dvec2 d = size * glm::dvec2(t.between(-1, 1), t.between(-1, 1));
                    return glm::vec3(d, glm::dot(s, d));
                  };
                  const glm::vec3 dx = step(), dy = step();
                  const glm::dvec2 a(dx), b(dy);
                  const double sine = std::abs(a.x * b.y - a.y * b.x) / (glm::length(a) * glm::length(b));
                  // What the rounded steps themselves say.
                  const double det = a.x * b.y - a.y * b.x;
                  const Values expected{(double(dx.z) * b.y - a.y * double(dy.z)) / det,
                                        (a.x * double(dy.z) - double(dx.z) * b.x) / det};
                  return sine < 1e-3 ? 0 : relative_difference(slope(dx, dy), expected) * sine;
                });
              });
}

}  // namespace

void add_bias_rows(Table& table, ShaderFunctions& shaders) {
  add_constant_rows(table, shaders);
  add_slope_rows(table, shaders);
  add_normal_rows(table, shaders);
  add_plane_rows(table, shaders);
}

}  // namespace atelier::stability
