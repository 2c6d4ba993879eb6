// point_shadow_factor: bias, distance and comparison together, where points touch the lamp, are out of its reach, or
// are met by light at a grazing angle, in scenes of a millimetre and of a thousand kilometres.
#include "stability/04-point-shadows/rows.hpp"

namespace atelier::stability {

namespace {

const char* const bias_names[] = {"none", "constant", "slope", "normal"};

struct Point {
  glm::vec3 position{0}, normal{0}, to_light{0};
};

struct Lamp {
  glm::vec3 position{0};
  float far = 1;
};

/// The factors of points around a lamp with a cube of 64 x 64 texels, bias 1, 3x3 comparisons.
Values factors(ShaderFunctions& shaders, int bias, const Lamp& lamp, const std::vector<Point>& points,
               const std::array<float, 6>& faces = all_half) {
  const OwnedCube cube = filled_cube(shaders.gl(), 64, GL_DEPTH_COMPONENT32F, false, faces);
  ShaderFunction function = lookup_function(
      {"position", "normal", "to_light", "lamp"},
      "vec4(point_shadow_factor(CubeLight(lamp.xyz, lamp.w, 0), position.xyz, normal.xyz, to_light.xyz))",
      {.bias = bias, .pcf = 3});
  function.uniforms = {{"u_bias", {1}}, {"u_depth_epsilon", {1e-6}}};
  function.cubes = {{"u_cube_0", cube.texture.id()}};
  std::vector<ShaderInput> inputs;
  for (const Point& p : points)
    inputs.push_back(input_of(p.position, p.normal, p.to_light, glm::vec4(lamp.position, lamp.far)));
  return shaders.numbers(function, inputs);
}

/// A point at `share` of the lamp's farthest distance whose surface light meets at `angle` to its normal.
Point point_at(const Lamp& lamp, const glm::dvec3& direction, double share, double angle) {
  const glm::dvec3 aside = glm::normalize(glm::cross(direction, glm::dvec3(0.3, 0.5, 0.8)));
  return {glm::vec3(glm::dvec3(lamp.position) + share * double(lamp.far) * direction),
          glm::vec3(-std::cos(angle) * direction + std::sin(angle) * aside), glm::vec3(-direction)};
}

void add_rows(Group& group, ShaderFunctions& shaders, int bias) {
  const auto ask = [&shaders, bias](const Lamp& lamp, const std::vector<Point>& points,
                                    const std::array<float, 6>& faces = all_half) {
    return factors(shaders, bias, lamp, points, faces);
  };
  group.equals("at the lamp: lit, with and without a normal",
               [=] {
                 return ask({{1, 2, 3}, 5}, {{{1, 2, 3}, {0, 1, 0}, {0, 1, 0}}, {{1, 2, 3}, {}, {}}});
               },
               {1, 1});
  group.equals(
      "before and behind what casts, without a normal, without a way to the light",
      [=] {
        return ask({}, {{{0.4f, 0, 0}}, {{0.6f, 0, 0}}, {{0, 0.4f, 0}, {}, {0, -1, 0}}, {{0, 0.6f, 0}, {0, -1, 0}}});
      },
      {1, 0, 1, 0});
  group.equals("something on one side of the lamp alone, each of six: shadow there, light on the other five",
               [=] {
                 double wrong = 0;
                 for (std::size_t near = 0; near < 6; ++near) {
                   std::array<float, 6> faces;
                   faces.fill(1);
                   faces[near] = 0.25f;
                   std::vector<Point> points;
                   for (int side = 0; side < 6; ++side) {
                     glm::dvec3 direction(0);
                     direction[side / 2] = side % 2 ? -1 : 1;
                     points.push_back(point_at({}, direction, 0.5, 0.1));
                   }
                   const Values found = ask({}, points, faces);
                   for (std::size_t side = 0; side < 6; ++side) wrong += found[side] != (side == near ? 0 : 1);
                 }
                 return Values{wrong};
               },
               {0});
  group.equals("beyond the farthest distance, also 1e12 times: in the shadow of what casts, and lit where nothing does",
               [=] {
                 return ask({},
                            {{{2, 0, 0}, {-1, 0, 0}, {-1, 0, 0}},
                             {{1e12f, 0, 0}, {-1, 0, 0}, {-1, 0, 0}},
                             {{0, 2, 0}, {0, -1, 0}, {0, -1, 0}},
                             {{0, 1e12f, 0}, {0, -1, 0}, {0, -1, 0}}},
                            {0.5f, 0.5f, 1, 1, 1, 1});
               },
               {0, 0, 1, 1});
  group.equals("light along the surface, and from behind it, 600 directions: no NaN, nothing outside 0..1",
               [=] {
                 std::vector<Point> points;
                 for (int i = 0; i < 600; ++i) {
                   Trial t(440, i);
                   const double angle = (i % 3 == 0 ? 89.99 : i % 3 == 1 ? 90 : 180) * std::numbers::pi / 180;
                   points.push_back(point_at({}, t.direction(), t.between(0.001, 1.5), angle));
                 }
                 return Values{count_outside(ask({}, points), 0, 1)};
               },
               {0});
  for (const float far : {1e-6f, 1e-3f, 1e5f, 1e9f})
    group.equals(fmt::format("a lamp that reaches {:g} m: 500 points at 0.4 of it lit, at 0.6 in shadow", far),
                 [=] {
                   std::vector<Point> before, behind;
                   for (int i = 0; i < 500; ++i) {
                     Trial t(441, i);
                     const glm::dvec3 direction = t.direction();
                     before.push_back(point_at({{0, 0, 0}, far}, direction, 0.4, 0.8));
                     behind.push_back(point_at({{0, 0, 0}, far}, direction, 0.6, 0.8));
                   }
                   return Values{count_others(ask({{0, 0, 0}, far}, before), {1}),
                                 count_others(ask({{0, 0, 0}, far}, behind), {0})};
                 },
                 {0, 0});
  group.equals("a lamp 1e6 m from the origin that reaches 10 m: 500 points",
               [=] {
                 const Lamp lamp{{1e6f, -1e6f, 1e6f}, 10};
                 std::vector<Point> before, behind;
                 for (int i = 0; i < 500; ++i) {
                   Trial t(442, i);
                   const glm::dvec3 direction = t.direction();
                   before.push_back(point_at(lamp, direction, 0.4, 0.8));
                   behind.push_back(point_at(lamp, direction, 0.6, 0.8));
                 }
                 return Values{count_others(ask(lamp, before), {1}), count_others(ask(lamp, behind), {0})};
               },
               {0, 0});
}

}  // namespace

void add_factor_rows(Table& table, ShaderFunctions& shaders) {
  for (int bias = 0; bias <= 3; ++bias) {
    Group group = table.of(fmt::format("point_shadow_factor, bias {} (GLSL)", bias_names[bias]));
    add_rows(group, shaders, bias);
  }
}

}  // namespace atelier::stability
