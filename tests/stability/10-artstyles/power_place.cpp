// power_place: sources up to 20 half heights away, strengths of 0 to 10, powers of 1 to 8; how well the root solves the
// equation, in double precision.
#include "stability/10-artstyles/rows.hpp"

namespace atelier::stability {

namespace {

/// A call: texture coordinates, the size, (strength, power).
ShaderInput place_call(const glm::vec2& source, const glm::vec2& size, double strength, double power) {
  return input_of(source, size, glm::vec2(strength, power));
}

/// How far the place is from the exact one, as a share of the 1e-5 of its distance that the contract allows, and of
/// what texture coordinates are rounded. The distance along the ray is the residual of r + strength r^(power + 1) =
/// distance of the source, over that function's slope.
double root_error(const ShaderInput& in, const glm::vec4& out) {
  const glm::vec2 size(in[1]);
  const glm::dvec2 source = place_of(glm::vec2(in[0]), size), place = place_of(glm::vec2(out), size);
  const double wanted = glm::length(source), strength = double(in[2].x), power = double(in[2].y);
  const double rounding = 2 * texcoord_rounding(glm::vec2(out), size);
  if (wanted == 0) return glm::length(place) / rounding;
  const glm::dvec2 way = source / wanted;
  const double r = glm::dot(place, way), beside = std::abs(place.x * way.y - place.y * way.x);
  if (!(r >= 0)) return double(INFINITY);
  const double bent = strength * std::pow(r, power);
  const double residual = r + r * bent - wanted, slope = 1 + (power + 1) * bent;
  return std::hypot(residual / slope, beside) / (1e-5 * r + rounding);
}

/// 12264 sources, up to 20 half heights away.
std::vector<ShaderInput> grid_of_sources(const glm::vec2& size, double farthest, double strength, double power) {
  std::vector<ShaderInput> calls;
  for (const glm::dvec2& at : polar_grid(farthest))
    calls.push_back(
        place_call(texcoord_of(at.x * glm::dvec2(std::cos(at.y), std::sin(at.y)), size), size, strength, power));
  return calls;
}

const Bound root_bound{1, "of what is allowed",
                       "the contract's 1e-5 of the distance; texture coordinates are rounded to 2^-24"};

}  // namespace

void add_power_place_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("power_place (GLSL)");
  const ShaderFunction function =
      style_function({"source", "size", "s"}, "vec4(power_place(source.xy, size.xy, s.x, s.y), 0.0, 0.0)");
  const ShaderFunction there_and_back =
      style_function({"texcoord", "size", "s"},
                     "vec4(power_place(power_source(texcoord.xy, size.xy, s.x, s.y), size.xy, s.x, s.y), 0.0, 0.0)");
  constexpr glm::vec2 wide(1920, 1080);
  for (const double strength : {0.0, 1e-6, 0.01, 0.3, 1.0, 10.0})
    for (const double power : {1.0, 2.0, 3.7, 8.0}) {
      const auto words = [=](const char* what) {
        return fmt::format("strength {:g}, power {:g}: {}", strength, power, what);
      };
      const auto calls = [=] { return grid_of_sources(wide, 20, strength, power); };
      group.equals(words("12264 sources up to 20 half heights away: those that fail"),
                   [=, &shaders] { return Values{count_failed(shaders, function, calls(), root_error)}; }, {0});
      group.close(words("12264 sources up to 20 half heights away: the worst"), root_bound,
                  [=, &shaders] { return worst_result(shaders, function, calls(), root_error); });
      group.equals(words("12264 places up to 1.5 half heights away, to their sources and back: those that fail"),
                   [=, &shaders] {
                     const std::vector<ShaderInput> places = grid_of_sources(wide, 1.5, strength, power);
                     return Values{count_failed(
                         shaders, there_and_back, places, [=](const ShaderInput& in, const glm::vec4& out) {
                           const glm::dvec2 place = place_of(glm::vec2(in[0]), wide);
                           const double r = glm::length(place), bent = strength * std::pow(r, power);
                           const double slope = 1 + (power + 1) * bent;
                           // The source's own roundings come back divided by the slope.
                           const glm::vec2 source = texcoord_of(place * (1 + bent), wide);
                           const double from_source =
                               (r * bent * pow_error(r, power) + 2 * texcoord_rounding(source, wide)) / slope;
                           const double allowed = 1e-5 * r + 2 * texcoord_rounding(glm::vec2(out), wide) + from_source;
                           return glm::length(place_of(glm::vec2(out), wide) - place) / allowed;
                         })};
                   },
                   {0});
    }
  group.equals("12264 random sources, strengths of 0 to 10, powers of 1 to 8, up to 20 half heights: those that fail",
               [=, &shaders] {
                 std::vector<ShaderInput> calls;
                 for (int i = 0; i < polar_count; ++i) {
                   Trial t(1180, i);
                   const glm::vec2 size = std::array{wide, glm::vec2(1, 1), glm::vec2(1, 4096)}[std::size_t(i % 3)];
                   const double r = t.size_between(1e-4, 20), a = t.between(0, 2 * std::numbers::pi);
                   const double strength = i % 2 == 0 ? t.between(0, 10) : t.size_between(1e-9, 10);
                   calls.push_back(place_call(texcoord_of(r * glm::dvec2(std::cos(a), std::sin(a)), size), size,
                                              strength, t.between(1, 8)));
                 }
                 return Values{count_failed(shaders, function, calls, root_error)};
               },
               {0});
  for (const double distance : {1e-6, 1e-3, 1.0, 20.0})
    group.close(fmt::format("sources {:g} half heights away, 16384 x 1 and 1 x 16384", distance), root_bound,
                [=, &shaders] {
                  std::vector<ShaderInput> calls;
                  for (const glm::vec2& size : {glm::vec2(16384, 1), glm::vec2(1, 16384)})
                    for (const double strength : {1e-9, 1.0, 10.0})
                      for (const double power : {1.0, 8.0})
                        for (int i = 0; i < 16; ++i) {
                          const double a = 2 * std::numbers::pi * i / 16;
                          calls.push_back(place_call(texcoord_of(distance * glm::dvec2(std::cos(a), std::sin(a)), size),
                                                     size, strength, power));
                        }
                  return worst_result(shaders, function, calls, root_error);
                });
  group.equals("the centre, strengths of 0 to 10, powers of 1 to 8: how often it moves",
               [=, &shaders] {
                 std::vector<ShaderInput> calls;
                 for (const double strength : {0.0, 1e-30, 0.3, 10.0})
                   for (const double power : {1.0, 1.5, 8.0})
                     calls.push_back(place_call(glm::vec2(0.5f), wide, strength, power));
                 return Values{count_failed(shaders, function, calls, [](const ShaderInput&, const glm::vec4& out) {
                   return glm::vec2(out) == glm::vec2(0.5f) ? 0.0 : 2.0;
                 })};
               },
               {0});
  add_nan_row(group, shaders, function, place_call({0.2f, 0.9f}, wide, 0.3, 2));
}

}  // namespace atelier::stability
