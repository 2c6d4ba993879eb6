// linear_depth, penumbra_width, blocker_depth and pcss: planes close together and far apart, lights without width,
// blockers where the light is.
#include "stability/03-shadow-mapping/rows.hpp"

namespace atelier::stability {

namespace {

/// A call over a light and up to four more numbers, `v`.
class OfLight {
 public:
  OfLight(ShaderFunctions& shaders, const std::string& call) : shaders_(&shaders), call_(call) {}
  double operator()(const glm::vec4& light, bool sun, const glm::vec4& v) const {
    const ShaderFunction function =
        shadow_function({"in_light", "directional", "v"}, "vec4(" + call_ + ")", {.samples = 4});
    return shaders_->number(function, input_of(light, float(sun), v));
  }

 private:
  ShaderFunctions* shaders_;
  std::string call_;
};

void add_depth_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("linear_depth (GLSL)");
  const OfLight linear(shaders, fmt::format("linear_depth({}, v.x)", plain_light));
  for (const double ratio : {1.0001, 10.0, 1000.0, 1e5})
    for (const bool sun : {false, true})
      group.close(
          fmt::format("far/near {:g}, {}: 0 and 1 are the planes", ratio, sun ? "a sun" : "a spot"),
          {8 * rounding_unit * ratio, "relative", "f - z (f - n) loses far/near of its digits at the far plane"}, [=] {
            const glm::vec4 light(1, 2, float(2 * ratio), 0);
            return each_relative({linear(light, sun, glm::vec4(0)), linear(light, sun, glm::vec4(1))},
                                 {2, double(light.z)});
          });
  group.close(
      "500 random depths of a spot from 0.1 to 100 m: as the projection has them",
      {8 * rounding_unit * 1000, "relative", "as above, far/near being 1000"}, [=] {
        return worst_of(500, 306, [&](Trial& t) {
          const float z = float(t.between(0, 1));
          const double n = double(0.1f), f = 100;
          return std::abs(linear({1, 0.1f, 100, 0}, false, glm::vec4(z)) * (f - double(z) * (f - n)) / (n * f) - 1);
        });
      });
}

void add_width_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("penumbra_width (GLSL)");
  const OfLight width(shaders, fmt::format("penumbra_width({}, v.x, v.y)", plain_light));
  const auto spot = [=](float light, float receiver, float blocker) {
    return Values{width({1, 0.1f, 100, light}, false, {receiver, blocker, 0, 0})};
  };
  const auto sun = [=](float light, float receiver, float blocker) {
    return Values{width({1, 0.1f, 100, light}, true, {receiver, blocker, 0, 0})};
  };
  group.equals("the blocker on the receiver", [=] { return Values{spot(1, 2, 2)[0], sun(1, 2, 2)[0]}; }, {0, 0});
  group.equals("a light without width, the blocker a micrometre before it", [=] { return spot(0, 1e6f, 1e-6f); }, {0});
  group.equals("a sun without width, the blocker where depth begins", [=] { return sun(0, 4, 0); }, {0});
  group.equals("a sun's blocker where depth begins", [=] { return sun(0.5f, 4, 0); }, {2});
  group.finite("a spot's blocker a micrometre before a light of 10 m, 1e6 m away",
               [=] { return spot(10, 1e6f, 1e-6f); });
}

/// A map under pcss or its search, with a light of (half-width, near, far, width).
class SoftMap {
 public:
  SoftMap(ShaderFunctions& shaders, std::initializer_list<float> depths, bool random, const char* call)
      : shaders_(&shaders), map_(std::make_shared<DepthMap>(shaders.gl(), depths)) {
    function_ =
        map_->read_by(shadow_function({"in_light", "directional", "at", "v"},
                                      fmt::format(fmt::runtime(call), plain_light), {.samples = 16, .random = random}));
  }
  double operator()(const glm::vec4& light, bool sun, const glm::vec3& at, const glm::vec4& v) const {
    return shaders_->number(function_, input_of(light, float(sun), at, v));
  }

 private:
  ShaderFunctions* shaders_;
  std::shared_ptr<DepthMap> map_;
  ShaderFunction function_;
};

void add_blocker_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("blocker_depth (GLSL)");
  for (const bool random : {false, true}) {
    const char* call = "vec4(blocker_depth({}, at.xyz, v.xy, v.z))";
    const SoftMap half(shaders, {0.5f}, random, call), near(shaders, {0, 0, 0, 0}, random, call);
    const glm::vec4 light(1, 1, 4, 0.5f);
    const char* how = random ? "random" : "grid";
    group.equals(fmt::format("{}: nothing nearer than the plane", how),
                 [=] {
                   return Values{half(light, true, {0.5f, 0.5f, 0.5f}, {0, 0, 0.5f, 0})};
                 },
                 {-1});
    group.equals(fmt::format("{}: nothing in sight of a search beside the map", how),
                 [=] {
                   return Values{half(light, true, {9, 9, 0.9f}, {0, 0, 0.5f, 0})};
                 },
                 {-1});
    group.close(fmt::format("{}: a search without width finds the one texel", how),
                {4 * rounding_unit, "absolute", "a mean of equal numbers"}, [=] {
                  return std::abs(half(light, true, {0.5f, 0.5f, 0.9f}, glm::vec4(0)) - 2.5);
                });
    group.close(fmt::format("{}: blockers on the near plane", how), {8 * rounding_unit, "absolute", "as linear_depth"},
                [=] {
                  return std::abs(near(light, false, {0.5f, 0.5f, 0.9f}, {0, 0, 0.25f, 0}) - 1);
                });
    group.finite(fmt::format("{}: a plane that rises a hundredfold, a search as wide as the map", how), [=] {
      return Values{half(light, false, {0.5f, 0.5f, 0.5f}, {100, -100, 1, 0})};
    });
  }
}

void add_pcss_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("pcss (GLSL)");
  for (const bool random : {false, true}) {
    const SoftMap soft(shaders, {0.5f}, random, "vec4(pcss({}, at.xyz, v.xy, v.z))");
    const char* how = random ? "random" : "grid";
    const glm::vec4 light(1, 1, 4, 0.5f), point(1, 1, 4, 0);
    const auto words = [how](const char* extreme) { return fmt::format("{}: {}", how, extreme); };
    group.equals(words("behind the light: z = 2"),
                 [=] {
                   return Values{soft(light, false, {0, 0, 2}, {0, 0, -1, 0})};
                 },
                 {1});
    group.equals(words("nothing before the point"),
                 [=] {
                   return Values{soft(light, false, {0.5f, 0.5f, 0.4f}, {0, 0, 2, 0})};
                 },
                 {1});
    group.equals(words("a light without width: as one comparison"),
                 [=] {
                   return Values{soft(point, false, {0.5f, 0.5f, 0.9f}, {0, 0, 3, 0})};
                 },
                 {0});
    group.equals(words("a point before the near plane searches nothing"),
                 [=] {
                   return Values{soft(light, false, {0.5f, 0.5f, -0.2f}, {0, 0, 0.5f, 0})};
                 },
                 {1});
    for (const bool sun : {false, true})
      group.equals(words(sun ? "a sun of 45 degrees: a share" : "a lamp ten times as wide as it is far: a share"),
                   [=] {
                     const double share = soft({1, 1, 4, sun ? 1 : 30}, sun, {0.5f, 0.5f, 0.9f}, {1, -1, 3, 0});
                     return Values{double(share >= 0 && share <= 1)};
                   },
                   {1});
  }
}

}  // namespace

void add_soft_rows(Table& table, ShaderFunctions& shaders) {
  add_depth_rows(table, shaders);
  add_width_rows(table, shaders);
  add_blocker_rows(table, shaders);
  add_pcss_rows(table, shaders);
}

}  // namespace atelier::stability
