// comes_out: points on the exit's plane, at grazing angles, far away, and about odd exits.
#include "stability/07-stencil-portals/rows.hpp"

namespace atelier::stability {

namespace {

const ShaderFunction& comes_out_function() {
  static const ShaderFunction function{
      text_including("07-stencil-portals/stencil_portals.glsl"),
      {"p", "d", "x", "y", "z", "origin", "half_size"},
      "vec4(comes_out(p.xyz, d.xyz, mat4(x, y, z, origin), half_size.xy) ? 1.0 : 0.0)"};
  return function;
}

/// Of 4000 points about exits `distance` metres away and images behind them, how many are judged wrongly. The line
/// meets the plane by similar triangles in the exit's frame. Points and lines that rounding decides are left out, and
/// less than half of them may be.
double misjudged_points(ShaderFunctions& shaders, double distance) {
  constexpr int count = 4000;
  std::vector<ShaderInput> inputs;
  Values expected;
  for (int i = 0; i < count; ++i) {
    Trial t(810, i);
    const glm::dmat4 exit = odd_frame(t, distance);
    const glm::dvec2 half_size{t.between(0.5, 2), t.between(0.5, 2)};
    const glm::dvec3 p{t.between(-4, 4), t.between(-4, 4), t.between(-1, 4)};
    const glm::dvec3 image{t.between(-4, 4), t.between(-4, 4), t.between(-4, -0.5)};
    const glm::dvec3 to_image = glm::normalize(image - p);
    // A point is rounded, and so is each entry of the matrix that it is multiplied by.
    const double noise = 32 * rounding_unit * (distance + 10);
    if (std::abs(p.z) < noise) continue;
    if (p.z > 0) {
      const glm::dvec2 met = (glm::dvec2(image) * p.z - glm::dvec2(p) * image.z) / (p.z - image.z);
      const glm::dvec2 outside = glm::abs(met) - half_size;
      if (std::abs(std::max(outside.x, outside.y)) < 4 * noise / std::abs(to_image.z)) continue;
      expected.push_back(outside.x < 0 && outside.y < 0);
    } else {
      expected.push_back(0);
    }
    const Exact to_light = at(exit, Exact(to_image)) - origin(exit);
    inputs.push_back(input_of(glm::vec3(at(exit, Exact(p))), glm::vec3(to_light), view_of(exit), glm::vec2(half_size)));
  }
  if (expected.size() < count / 2) return double(infinite);
  const Values answers = shaders.numbers(comes_out_function(), inputs);
  double wrong = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) wrong += answers[i] != expected[i];
  return wrong;
}

/// The matrix of an exit at this place, not turned: from the world to its frame.
glm::mat4 exit_at(const glm::vec3& place) {
  glm::mat4 world_to_exit(1);
  world_to_exit[3] = glm::vec4(-place, 1);
  return world_to_exit;
}

}  // namespace

void add_light_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("comes_out (GLSL)");
  struct Line {
    glm::vec3 p, to_light;
    glm::vec2 half_size{1};
    glm::mat4 world_to_exit{1};
  };
  const auto row = [&](const char* what, const Line& line, double expected) {
    group.equals(what,
                 [=, &shaders] {
                   return Values{shaders.number(comes_out_function(),
                                                input_of(line.p, line.to_light, line.world_to_exit, line.half_size))};
                 },
                 {expected});
  };
  const glm::vec3 ahead(0, 0, -1);  // towards a light straight behind the exit

  row("on the plane", {{0.5f, 0.5f, 0}, ahead}, 0);
  row("on the plane of an exit at 5 m", {{0, 0, 5}, ahead, glm::vec2(1), exit_at({0, 0, 5})}, 0);
  row("one float before it", {{0, 0, std::nextafter(5.0f, 9.0f)}, ahead, glm::vec2(1), exit_at({0, 0, 5})}, 1);
  row("one float behind it", {{0, 0, std::nextafter(5.0f, 0.0f)}, ahead, glm::vec2(1), exit_at({0, 0, 5})}, 0);
  row("1e-30 m before the plane", {{0.5f, 0.5f, 1e-30f}, ahead}, 1);
  row("1e-30 m behind the plane", {{0.5f, 0.5f, -1e-30f}, ahead}, 0);
  row("1e30 m before the exit", {{0.5f, 0.5f, 1e30f}, ahead}, 1);
  row("1e30 m before the exit, beside it", {{1.5f, 0.5f, 1e30f}, ahead}, 0);
  row("1e30 m behind the exit", {{0.5f, 0.5f, -1e30f}, ahead}, 0);
  row("1e30 m before the exit, towards another place", {{0, 0, 1e30f}, {0.6f, 0, -0.8f}}, 0);

  // Grazing: from (0, 0, z) towards (-1, 0, -slope) the line meets the plane at x = -z / slope.
  row("slope 2e-6, meets the plane within the opening", {{0, 0, 1e-6f}, {-1, 0, -2e-6f}}, 1);
  row("slope 2e-7, meets the plane beside it", {{0, 0, 1e-6f}, {-1, 0, -2e-7f}}, 0);
  row("slope 2e-30, meets the plane within the opening", {{0, 0, 1e-30f}, {-1, 0, -2e-30f}}, 1);
  row("slope 2e-30, meets the plane 5e29 m away", {{0, 0, 1}, {-1, 0, -2e-30f}}, 0);
  row("slope 2e-30, meets the plane farther away than floats reach", {{0, 0, 1e30f}, {-1, 0, -2e-30f}}, 0);
  row("the same towards a corner", {{0, 0, 1e30f}, {-0.6f, 0.8f, -2e-30f}}, 0);

  row("half a size of 1e-6 m, through its middle", {{0, 0, 1}, ahead, glm::vec2(1e-6f)}, 1);
  row("half a size of 1e-6 m, 2e-6 m beside the middle", {{2e-6f, 0, 1}, ahead, glm::vec2(1e-6f)}, 0);
  row("half a size of 1e6 m, 1 m within its corner", {{999999, -999999, 1}, ahead, glm::vec2(1e6f)}, 1);
  row("half a size of 1e6 m, 1 m beyond its side", {{0, 1000001, 1}, ahead, glm::vec2(1e6f)}, 0);
  row("the largest float as half a size", {{1e30f, -1e30f, 1}, ahead, glm::vec2(largest_float)}, 1);
  row("no extent, 1 mm beside it", {{0, 1e-3f, 1}, ahead, glm::vec2(0)}, 0);

  const glm::mat4 far_exit = exit_at({1e6f, -1e6f, 1e6f});
  row("an exit a million metres away along each axis", {{1e6f + 0.5f, -1e6f, 1e6f + 2}, ahead, glm::vec2(1), far_exit},
      1);
  row("the same, beside it", {{1e6f + 1.5f, -1e6f, 1e6f + 2}, ahead, glm::vec2(1), far_exit}, 0);
  row("the same, on its plane", {{1e6f + 0.5f, -1e6f, 1e6f}, ahead, glm::vec2(1), far_exit}, 0);
  row("the same, behind it", {{1e6f + 0.5f, -1e6f, 1e6f - 2}, ahead, glm::vec2(1), far_exit}, 0);

  for (const double distance : {1.0, 1e3})
    group.equals(fmt::format("4000 points and images about odd exits {:g} m away: misjudged", distance),
                 [=, &shaders] { return Values{misjudged_points(shaders, distance)}; }, {0});
}

}  // namespace atelier::stability
