// attenuation, spot_cone and the three kinds of arriving light: touching, far away, all round and not at all.
#include "stability/02-blinn-phong/rows.hpp"

namespace atelier::stability {

namespace {

void add_attenuation_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("attenuation (GLSL)");
  const auto attenuation = [&shaders](float distance, const glm::vec3& c) {
    const ShaderFunction function = blinn_phong_function({"d", "c"}, "vec4(attenuation(d.x, c.xyz))");
    return shaders.number(function, input_of(distance, c));
  };
  const auto exact = [](float distance, const glm::dvec3& c) {
    const double d = std::max(double(distance), 0.001);
    return 1 / (c.x + c.y * d + c.z * d * d);
  };
  const Bound bound{8 * rounding_unit, "relative", "three products, two sums and a quotient, which GLSL gives 2.5 ulp"};
  for (const float distance : {0.0f, 1e-30f, 0.001f, 1.0f, 1e6f, 1e18f})
    for (const glm::vec3& c : {glm::vec3(0, 0, 1), glm::vec3(1, 0.1f, 0.01f), glm::vec3(0, 1e-6f, 0)})
      group.close(fmt::format("{:g} m, coefficients ({:g}, {:g}, {:g})", distance, c.x, c.y, c.z), bound,
                  [=] { return std::abs(attenuation(distance, c) / exact(distance, c) - 1); });
  group.equals("1e18 m, constant 1e-30: what arrives is still a number",
               [=] {
                 return Values{double(std::isfinite(attenuation(1e18f, {1e-30f, 0, 0})))};
               },
               {1});
  group.equals("it never rises with the distance, 1 mm to 10 km",
               [=] {
                 double rises = 0, before = infinite;
                 for (int i = 0; i <= 140; ++i) {
                   const double here = attenuation(std::pow(10.0f, -3 + float(i) / 20), {0.1f, 0.2f, 0.3f});
                   rises += here > before;
                   before = here;
                 }
                 return Values{rises};
               },
               {0});
}

void add_cone_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("spot_cone (GLSL)");
  const ShaderFunction cone = blinn_phong_function({"to_light", "axis", "cosines"},
                                                   "vec4(spot_cone(to_light.xyz, axis.xyz, cosines.x, cosines.y))");
  /// At an angle off the axis, in radians.
  const auto at_angle = [&shaders, cone](double angle, float inner, float outer) {
    const glm::vec3 along(std::sin(angle), 0, -std::cos(angle));
    return shaders.number(cone, input_of(-along, glm::vec3(0, 0, -1), glm::vec2(inner, outer)));
  };
  /// The share of 4096 random axes whose light is lost at just this angle off the axis, 0 or pi.
  const auto lost = [&shaders, cone](float side, float cosine) {
    std::vector<ShaderInput> inputs;
    for (int i = 0; i < 4096; ++i) {
      const glm::vec3 axis(Trial(110, i).direction());
      inputs.push_back(input_of(-side * axis, axis, glm::vec2(cosine)));
    }
    double count = 0;
    for (const glm::vec4& light : shaders.evaluate(cone, inputs)) count += light.x != 1.0f;
    return count / 4096;
  };
  group.equals("a cone of 179.9 degrees, a hard edge: light straight behind is lost",
               [=] { return Values{lost(-1, std::cos(3.1398472f))}; }, {1});
  group.equals("a cone of 180 degrees: light straight behind is kept", [=] { return Values{lost(-1, -1)}; }, {0});
  group.equals("a cone of 180 degrees: light straight ahead", [=] { return Values{lost(1, -1)}; }, {0});
  group.equals("equal cosines of 0.5: lit at 59.9 degrees, dark at 60.1",
               [=] {
                 return Values{at_angle(1.0455, 0.5f, 0.5f), at_angle(1.0489, 0.5f, 0.5f)};
               },
               {1, 0});
  group.equals(
      "equal cosines of 0: lit on the edge itself",
      [=, &shaders] { return Values{shaders.number(cone, input_of(glm::vec3(-1, 0, 0), glm::vec3(0, 0, -1), 0.0f))}; },
      {1});
  group.equals("a cone of 0 on its axis, exactly represented",
               [=, &shaders] {
                 return Values{shaders.number(cone, input_of(glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec2(1)))};
               },
               {1});
  group.finite("cosines one float apart", [=] {
    const float inner = 0.5f, outer = std::nextafter(0.5f, 0.0f);
    return Values{at_angle(1.0, inner, outer), at_angle(1.0471976, inner, outer), at_angle(1.1, inner, outer)};
  });
  group.close("from 10 to 170 degrees, 200 angles",
              {2e-6, "absolute", "the cosine, two roundings, over the width of 1.97, times the curve's slope of 1.5"},
              [=] {
                const float inner = std::cos(0.17453292f), outer = std::cos(2.9670597f);
                double worst = 0;
                for (int i = 0; i < 200; ++i) {
                  const double angle = 3.14159265 * i / 199;
                  const double t = (std::cos(angle) - double(outer)) / (double(inner) - double(outer));
                  const double u = std::min(1.0, std::max(0.0, t));
                  worst = std::max(worst, std::abs(at_angle(angle, inner, outer) - u * u * (3 - 2 * u)));
                }
                return worst;
              });
}

/// The colour that arrives and the unit vector to the light, for a light of each kind: six numbers.
struct Arrival {
  glm::dvec3 light, to_light;
};

class Arriving {
 public:
  explicit Arriving(ShaderFunctions& shaders) : shaders_(&shaders) {}

  Arrival from_point(const glm::vec3& light, const glm::vec3& colour, const glm::vec3& coefficients,
                     const glm::vec3& position) const {
    return both("arriving_from_point(PointLight(light.xyz, colour.rgb, coefficients.xyz), position.xyz, to_light)",
                light, colour, coefficients, position);
  }
  /// A spot that shines down with a cone of 90 degrees to each side.
  Arrival from_spot(const glm::vec3& light, const glm::vec3& colour, const glm::vec3& coefficients,
                    const glm::vec3& position) const {
    return both(
        "arriving_from_spot(SpotLight(light.xyz, vec3(0.0, -1.0, 0.0), colour.rgb, coefficients.xyz, "
        "vec2(0.0)), position.xyz, to_light)",
        light, colour, coefficients, position);
  }
  Arrival from_direction(const glm::vec3& direction, const glm::vec3& colour) const {
    return both("arriving_from_direction(DirectionalLight(light.xyz, colour.rgb), position.xyz, to_light)", direction,
                colour, {}, {});
  }

 private:
  Arrival both(const std::string& call, const glm::vec3& light, const glm::vec3& colour, const glm::vec3& coefficients,
               const glm::vec3& position) const {
    const std::vector<std::string> names = {"light", "colour", "coefficients", "position"};
    const ShaderInput input = input_of(light, colour, coefficients, position);
    // The vector to the light comes out of the call, so it is read behind it.
    const std::string helpers =
        "vec3 to_light;\nvec4 first(vec3 arriving) { return vec4(arriving, 0.0); }\n"
        "vec4 second(vec3 arriving) { return vec4(to_light, 0.0); }\n";
    return {glm::dvec3(shaders_->evaluate(blinn_phong_function(names, "first(" + call + ")", {}, helpers), input)),
            glm::dvec3(shaders_->evaluate(blinn_phong_function(names, "second(" + call + ")", {}, helpers), input))};
  }
  ShaderFunctions* shaders_;
};

void add_point_rows(Table& table, const Arriving& arriving) {
  const glm::vec3 white(1), quadratic(0, 0, 1);
  const Bound unit{4e-7, "absolute", "a square root and a quotient: 2.5 ulp in GLSL, and the sum of the squares"};
  const auto length_error = [](const Arrival& a) { return std::abs(glm::length(a.to_light) - 1); };

  Group group = table.of("arriving_from_point (GLSL)");
  const glm::vec3 place(0.3f, 0.5f, -0.7f);
  group.equals("a light exactly at the position: none",
               [=] { return values(arriving.from_point(place, white, quadratic, place).light); }, {0, 0, 0});
  group.close("a light exactly at the position: still a unit vector", unit,
              [=] { return length_error(arriving.from_point(place, white, quadratic, place)); });
  group.close("a light 0.1 mm away counts as 1 mm away",
              {1e-6, "relative", "the millimetre, squared and inverted: 5 ulp"}, [=] {
                return std::abs(arriving.from_point({0, 1e-4f, 0}, white, quadratic, {}).light.r / 1e6 - 1);
              });
  for (const float distance : {1e-15f, 1e-6f, 1.0f, 1e6f, 1e15f, 1e18f})
    group.close(fmt::format("{:g} m away: a unit vector", distance), unit,
                [=] { return length_error(arriving.from_point(distance * place, white, quadratic, {})); });
  group.close("1e6 m from the origin, 2 m apart: light by the distance that floats leave",
              {1e-6, "relative", "the difference of these floats is exact; square, sum and quotient follow"}, [=] {
                const Arrival a = arriving.from_point({1e6f, 2, 1e6f}, white, quadratic, {1e6f, 0, 1e6f});
                return std::abs(a.light.r / 0.25 - 1);
              });
  group.finite("colours of 1e30 at a millimetre", [=] {
    return values(arriving.from_point({0, 1e-3f, 0}, glm::vec3(1e30f), quadratic, {}).light);
  });
  group.equals("a black light", [=] { return values(arriving.from_point(place, glm::vec3(0), quadratic, {}).light); },
               {0, 0, 0});
  group.close("300 random lights at 1e-6 to 1e6 m: a unit vector, and the right way",
              {6 * rounding_unit, "absolute", "the sum of squares, its root, and a quotient"}, [=] {
                return worst_of(300, 120, [&](Trial& t) {
                  const glm::vec3 light(t.size_between(1e-6, 1e6) * t.direction());
                  return difference(values(arriving.from_point(light, white, quadratic, {}).to_light),
                                    values(glm::normalize(glm::dvec3(light))));
                });
              });
}

void add_other_rows(Table& table, const Arriving& arriving) {
  const glm::vec3 white(1), quadratic(0, 0, 1);
  Group spot = table.of("arriving_from_spot (GLSL)");
  spot.equals("a light exactly at the position: none",
              [=] {
                return values(arriving.from_spot({1, 2, 3}, white, quadratic, {1, 2, 3}).light);
              },
              {0, 0, 0});
  spot.equals("above the lamp: none",
              [=] {
                return values(arriving.from_spot({0, 2, 0}, white, quadratic, {0, 5, 0}).light);
              },
              {0, 0, 0});
  spot.close("1e15 m below", {1e-6, "relative", "as for a point light"}, [=] {
    return std::abs(arriving.from_spot({0, 1e15f, 0}, white, quadratic, {}).light.r / 1e-30 - 1);
  });

  Group sun = table.of("arriving_from_direction (GLSL)");
  sun.equals("light of 1e30, straight down",
             [=] {
               const Arrival a = arriving.from_direction({0, -1, 0}, glm::vec3(1e30f));
               return Values{a.light.r, a.light.g, a.light.b, a.to_light.x, a.to_light.y, a.to_light.z};
             },
             {double(1e30f), double(1e30f), double(1e30f), 0, 1, 0});
  sun.equals("black light", [=] { return values(arriving.from_direction({1, 0, 0}, glm::vec3(0)).light); }, {0, 0, 0});
}

}  // namespace

void add_light_rows(Table& table, ShaderFunctions& shaders) {
  add_attenuation_rows(table, shaders);
  add_cone_rows(table, shaders);
  add_point_rows(table, Arriving(shaders));
  add_other_rows(table, Arriving(shaders));
}

}  // namespace atelier::stability
