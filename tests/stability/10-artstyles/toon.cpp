// toon: luma of 0 to 1e30, each of the six greys, brightnesses just beside half way between two, edges at both limits,
// limits that are one float apart.
#include "stability/10-artstyles/rows.hpp"

namespace atelier::stability {

namespace {

/// A call: the colour, then (edge, low, high).
ShaderInput toon_call(const glm::vec3& colour, float edge, float low, float high) {
  return input_of(colour, glm::vec3(edge, low, high));
}

double exact_luma(const glm::vec4& c) {
  return glm::dot(glm::dvec3(c), glm::dvec3(0.2126, 0.7152, 0.0722));
}

double brightness_of(const glm::vec4& c) {
  return std::sqrt(std::clamp(exact_luma(c), 0.0, 1.0));
}

double exact_light(const ShaderInput& in) {
  const double grey = std::round(5 * brightness_of(in[0])) / 5;
  const double t = std::clamp((double(in[1].x) - double(in[1].y)) / (double(in[1].z) - double(in[1].y)), 0.0, 1.0);
  return grey * grey * (1 - t * t * (3 - 2 * t));
}

/// The largest distance of a channel from the exact light; 0 where the brightness is too near to half way.
double light_error(const ShaderInput& in, const glm::vec4& out) {
  const double steps = 5 * brightness_of(in[0]) + 0.5;
  if (std::abs(steps - std::round(steps)) < 1e-5) return 0;
  return difference(values(glm::vec3(out)), Values(3, exact_light(in)));
}

ShaderInput random_call(Trial& t) {
  const double r = t.between(0, 1.2), g = t.between(0, 1.2), b = t.between(0, 1.2);
  const double low = t.between(0, 4), high = low + t.size_between(1e-3, 1);
  return toon_call(glm::vec3(r, g, b), float(t.between(0, 4.5)), float(low), float(high));
}

}  // namespace

void add_toon_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("toon (GLSL)");
  const ShaderFunction function = style_function({"c", "s"}, "vec4(toon(c.rgb, s.x, s.y, s.z), 0.0)");
  const auto of = [=, &shaders](const glm::vec3& colour, float edge, float low, float high) {
    return values(glm::vec3(shaders.evaluate(function, toon_call(colour, edge, low, high))));
  };
  const Bound grey_bound{6 * rounding_unit, "absolute", "a quotient of drivers, a square and a product, of up to 1"};
  for (const float light : {0.0f, -0.0f, denormal, 1e-38f, 1e-30f, 1e-6f, 0.0099f})
    group.equals(fmt::format("a grey of {:g}: black", light), [=] { return of(glm::vec3(light), 0, 1, 2); }, {0, 0, 0});
  for (const float light : {0.9f, 1.0f, 1.0000001f, 2.0f, 65504.0f, 1e30f, largest_float})
    group.close(fmt::format("a grey of {:.9g}: white", light), grey_bound, [=] {
      return difference(of(glm::vec3(light), 0, 1, 2), {1, 1, 1});
    });
  for (int k = 0; k <= 5; ++k) {
    const double light = k * k / 25.0;
    group.close(fmt::format("a grey of ({}/5)^2: itself", k), grey_bound,
                [=] { return difference(of(glm::vec3(light), 0, 1, 2), Values(3, light)); });
    if (k < 5)
      for (const double side : {-1.0, 1.0})
        group.close(
            fmt::format("a brightness just {} half way from {}/5 to {}/5", side < 0 ? "below" : "above", k, k + 1),
            grey_bound, [=] {
              const double root = (k + 0.5 + side * 1e-5) / 5, right = (side < 0 ? k : k + 1) / 5.0;
              return difference(of(glm::vec3(root * root), 0, 1, 2), Values(3, right * right));
            });
  }
  group.equals("10000 random colours: those that are no grey, or change when drawn again",
               [=, &shaders] {
                 std::vector<ShaderInput> calls;
                 for (int i = 0; i < 10'000; ++i) {
                   Trial t(1110, i);
                   calls.push_back(random_call(t));
                   calls.back()[1] = glm::vec4(0, 1, 2, 0);
                 }
                 const std::vector<glm::vec4> once = results_of(shaders, function, calls);
                 for (std::size_t i = 0; i < calls.size(); ++i) calls[i][0] = once[i];
                 const std::vector<glm::vec4> twice = results_of(shaders, function, calls);
                 double others = 0;
                 for (std::size_t i = 0; i < once.size(); ++i)
                   others += once[i].r != once[i].g || once[i].g != once[i].b || once[i] != twice[i];
                 return Values{others};
               },
               {0});
  for (const auto& [low, high] : {std::pair{0.0f, 1.0f},
                                  {0.0f, 1e-30f},
                                  {0.0f, 4.4721360f},
                                  {1.0f, std::nextafter(1.0f, 2.0f)},
                                  {std::nextafter(4.0f, 0.0f), 4.0f},
                                  {1e-3f, 4.0f}}) {
    const glm::vec3 colour(0.3f, 0.6f, 0.1f);
    const auto words = [low = low, high = high](const char* what) {
      return fmt::format("from {:.9g} to {:.9g}: {}", low, high, what);
    };
    group.same(
        words("an edge of 0, and one at the lower limit: no ink"),
        [=, low = low, high = high] {
          Values both = of(colour, 0, low, high);
          for (const double v : of(colour, low, low, high)) both.push_back(v);
          return both;
        },
        [=] {
          Values both = of(colour, 0, 4, 5);
          both.insert(both.end(), both.begin(), both.begin() + 3);
          return both;
        });
    group.close(words("an edge at the upper limit: black"),
                {6 * rounding_unit, "absolute", "drivers may round a quotient of two equal numbers"},
                [=, low = low, high = high] {
                  return difference(of(colour, high, low, high), {0, 0, 0});
                });
    group.equals(words("an edge of 4.48: black"), [=, low = low, high = high] { return of(colour, 4.48f, low, high); },
                 {0, 0, 0});
  }
  group.close("half way between the limits: half of the light", grey_bound, [=] {
    return difference(of(glm::vec3(1), 1.5f, 1, 2), {0.5, 0.5, 0.5});
  });
  group.close(
      "10000 random colours, edges of 0 to 4.5, limits 0.001 to 1 apart",
      {20 * rounding_unit, "absolute", "a quotient of drivers counts up to 1.5 times, and four products follow"},
      [=, &shaders] { return worst_of_calls(shaders, function, 10'000, 1111, random_call, light_error); });
  group.close("1000 edges that grow from 0 to 4.5: by how much the light rises",
              {6 * rounding_unit, "absolute", "the products that make the share of ink are rounded"}, [=, &shaders] {
                std::vector<ShaderInput> calls;
                for (int i = 0; i <= 1000; ++i)
                  calls.push_back(toon_call(glm::vec3(1), 4.5f * float(i) / 1000, 0.5f, 4));
                const std::vector<glm::vec4> found = results_of(shaders, function, calls);
                double rise = 0;
                for (std::size_t i = 1; i < found.size(); ++i)
                  rise = worse_of(rise, double(found[i].r) - double(found[i - 1].r));
                return rise;
              });
  add_nan_row(group, shaders, function, toon_call({0.3f, 0.6f, 0.1f}, 1.2f, 1, 2));
}

}  // namespace atelier::stability
