// fisheye_direction: the centre, half angles of 1e-3 to pi, places on the circle and beyond, pictures of 1 x 1 to
// 16384 x 1.
#include "stability/10-artstyles/rows.hpp"

namespace atelier::stability {

namespace {

ShaderInput direction_call(const glm::vec2& texcoord, const glm::vec2& size, float half_angle) {
  return input_of(texcoord, size, half_angle);
}

/// As a share of what roundings and sines allow; what is beyond the circle has no direction, and at its edge either is
/// right.
double direction_error(const ShaderInput& in, const glm::vec4& out) {
  const glm::vec2 size(in[1]);
  const glm::dvec2 place = place_of(glm::vec2(in[0]), size);
  const double r = glm::length(place), half_angle = double(in[2].x), angle = r * half_angle;
  const bool none = glm::vec3(out) == glm::vec3(0);
  if (r > 1 - 1e-5 && none) return 0;
  if (r > 1 + 1e-5) return 2;
  const glm::dvec2 way = r > 0 ? place / r : glm::dvec2(0);
  const glm::dvec3 exact(way * std::sin(angle), -std::cos(angle));
  const double allowed = 8 * half_angle * texcoord_rounding(glm::vec2(in[0]), size) * double(r > 0) + sine_error;
  return glm::length(glm::dvec3(out) - exact) / allowed;
}

/// Places of all the circle and around it.
std::vector<ShaderInput> places(const glm::vec2& size, float half_angle) {
  std::vector<ShaderInput> calls;
  for (const glm::dvec2& at : polar_grid(1.2))
    calls.push_back(
        direction_call(texcoord_of(at.x * glm::dvec2(std::cos(at.y), std::sin(at.y)), size), size, half_angle));
  return calls;
}

}  // namespace

void add_direction_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("fisheye_direction (GLSL)");
  const ShaderFunction function =
      style_function({"texcoord", "size", "angle"}, "vec4(fisheye_direction(texcoord.xy, size.xy, angle.x), 0.0)");
  const Bound bound{
      1, "of what roundings allow",
      "drivers' sine and cosine are taken as good to 2e-6; texture coordinates are rounded to 2^-24, and so "
      "are five products and sums of that size"};
  for (const glm::vec2& size : sizes)
    for (const float half_angle : {1e-3f, 0.5f, pi / 2, pi}) {
      const auto words = [=](const char* what) {
        return fmt::format("{:g} x {:g}, half an angle of {:.7g}: {}", size.x, size.y, half_angle, what);
      };
      group.equals(words("the centre: exactly ahead"),
                   [=, &shaders] {
                     return values(shaders.evaluate(function, direction_call({0.5f, 0.5f}, size, half_angle)));
                   },
                   {0, 0, -1, 0});
      group.close(words(fmt::format("{} places up to 1.2 half heights away", polar_count).c_str()), bound,
                  [=, &shaders] { return worst_result(shaders, function, places(size, half_angle), direction_error); });
      group.equals(words("the same places: directions that are neither of unit length nor none"),
                   [=, &shaders] {
                     return Values{count_failed(shaders, function, places(size, half_angle),
                                                [](const ShaderInput&, const glm::vec4& out) {
                                                  const double length = glm::length(glm::dvec3(out));
                                                  return length == 0 ? 0 : std::abs(length - 1) / (2 * sine_error);
                                                })};
                   },
                   {0});
      group.close(words("the float beside the centre: no NaN, and nearly ahead"), bound, [=, &shaders] {
        std::vector<ShaderInput> calls;
        for (const float beside : {std::nextafter(0.5f, 0.0f), std::nextafter(0.5f, 1.0f)}) {
          calls.push_back(direction_call({beside, 0.5f}, size, half_angle));
          calls.push_back(direction_call({0.5f, beside}, size, half_angle));
        }
        return worst_result(shaders, function, calls, direction_error);
      });
    }
  group.equals("1 x 1, all corners: no picture, half angles of 1e-3 to pi",
               [=, &shaders] {
                 double others = 0;
                 for (const float half_angle : {1e-3f, 0.5f, pi / 2, pi})
                   for (const float x : {0.0f, 1.0f})
                     for (const float y : {0.0f, 1.0f})
                       others += shaders.evaluate(function, direction_call({x, y}, {1, 1}, half_angle)) != glm::vec4(0);
                 return Values{others};
               },
               {0});
  group.close(
      "half an angle of 1e-3: 1000 places, of the angle",
      {1e-5, "of half the angle", "a sine of so small an angle is the angle; the length and a product are rounded"},
      [=, &shaders] {
        return worst_of_calls(
            shaders, function, 1000, 1140,
            [](Trial& t) {
              const double r = t.between(0, 0.99), a = t.between(0, 2 * std::numbers::pi);
              const glm::dvec2 place = r * glm::dvec2(std::cos(a), std::sin(a));
              return direction_call(texcoord_of(place, {1920, 1080}), {1920, 1080}, 1e-3f);
            },
            [](const ShaderInput& in, const glm::vec4& out) {
              const glm::dvec2 place = place_of(glm::vec2(in[0]), {1920, 1080});
              return glm::length(glm::dvec2(glm::vec2(out)) / double(1e-3f) - place);
            });
      });
  add_nan_row(group, shaders, function, direction_call({0.4f, 0.7f}, {1920, 1080}, 1));
}

}  // namespace atelier::stability
