// power_source: the centre, corners, pictures of 1 x 1 to 16384 x 1, the strongest lens, places along a ray.
#include "stability/10-artstyles/rows.hpp"

namespace atelier::stability {

namespace {

/// A call: texture coordinates, the size, (strength, power).
ShaderInput source_call(const glm::vec2& texcoord, const glm::vec2& size, double strength, double power) {
  return input_of(texcoord, size, glm::vec2(strength, power));
}

/// How far the source is from the exact one, as a share of what roundings allow.
double source_error(const ShaderInput& in, const glm::vec4& out) {
  const glm::vec2 size(in[1]);
  const glm::dvec2 place = place_of(glm::vec2(in[0]), size);
  const double r = glm::length(place), strength = double(in[2].x), power = double(in[2].y);
  const double bent = strength * std::pow(r, power);
  const glm::dvec2 exact = place * (1 + bent);
  const double allowed =
      r * (bent * (pow_error(r, power) + 4 * power * rounding_unit) + 6 * (1 + bent) * rounding_unit) +
      2 * texcoord_rounding(texcoord_of(exact, size), size);
  return glm::length(place_of(glm::vec2(out), size) - exact) / allowed;
}

std::string size_words(const glm::vec2& size) {
  return fmt::format("{:g} x {:g}", size.x, size.y);
}

}  // namespace

void add_power_source_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("power_source (GLSL)");
  const ShaderFunction function =
      style_function({"texcoord", "size", "s"}, "vec4(power_source(texcoord.xy, size.xy, s.x, s.y), 0.0, 0.0)");
  const Bound bound{
      1, "of what roundings allow",
      "the length and the sums are rounded; of a power later GLSL demands what exp2 and log2 give; texture "
      "coordinates are rounded to 2^-24"};
  for (const glm::vec2& size : sizes) {
    group.equals(fmt::format("{}: the centre, strengths 0 to 10, powers 1 to 8: how often it moves", size_words(size)),
                 [=, &shaders] {
                   std::vector<ShaderInput> calls;
                   for (const double strength : {0.0, 1e-30, 0.3, 10.0})
                     for (const double power : {1.0, 1.5, 2.0, 8.0})
                       calls.push_back(source_call(glm::vec2(0.5f), size, strength, power));
                   return Values{count_failed(shaders, function, calls, [](const ShaderInput&, const glm::vec4& out) {
                     return glm::vec2(out) == glm::vec2(0.5f) ? 0.0 : 2.0;
                   })};
                 },
                 {0});
    for (const double strength : {0.0, 1e-6, 0.3, 10.0})
      for (const double power : {1.0, 2.5, 8.0}) {
        const auto words = [=](const char* what) {
          return fmt::format("{}, strength {:g}, power {:g}: {}", size_words(size), strength, power, what);
        };
        group.close(words("corners, middles of edges, 1000 random places"), bound, [=, &shaders] {
          std::vector<ShaderInput> calls;
          for (const float x : {0.0f, 0.5f, 1.0f})
            for (const float y : {0.0f, 0.5f, 1.0f})
              if (x != 0.5f || y != 0.5f) calls.push_back(source_call({x, y}, size, strength, power));
          for (int i = 0; i < 1000; ++i) {
            Trial t(1130, i);
            const double x = t.between(0, 1);
            calls.push_back(source_call(glm::vec2(x, t.between(0, 1)), size, strength, power));
          }
          return worst_result(shaders, function, calls, source_error);
        });
        group.equals(words("1000 places from the centre to a corner: how often the source comes nearer"),
                     [=, &shaders] {
                       std::vector<ShaderInput> calls;
                       for (int i = 0; i <= 1000; ++i)
                         calls.push_back(source_call(glm::vec2(0.5f + 0.5f * float(i) / 1000), size, strength, power));
                       const std::vector<glm::vec4> found = results_of(shaders, function, calls);
                       double nearer = 0;
                       for (std::size_t i = 1; i < found.size(); ++i)
                         nearer += !(glm::length(place_of(glm::vec2(found[i]), size)) >
                                     glm::length(place_of(glm::vec2(found[i - 1]), size)));
                       return Values{nearer};
                     },
                     {0});
      }
  }
  group.close("10000 random places, strengths of 1e-3 to 10, powers of 1 to 8", bound, [=, &shaders] {
    return worst_of_calls(
        shaders, function, 10'000, 1131,
        [](Trial& t) {
          const glm::vec2 size = sizes[std::size_t(t.between(0, 2))];
          const double x = t.between(0, 1), y = t.between(0, 1);
          const double strength = t.size_between(1e-3, 10);
          return source_call(glm::vec2(x, y), size, strength, t.between(1, 8));
        },
        source_error);
  });
  add_nan_row(group, shaders, function, source_call({0.3f, 0.8f}, {1920, 1080}, 0.3, 2));
}

}  // namespace atelier::stability
