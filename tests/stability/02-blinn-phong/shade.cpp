// shade: the whole sum, with no light and with 64 of each kind, touching the surface, far from the origin, and with
// lights that something stands before.
#include "stability/02-blinn-phong/rows.hpp"

namespace atelier::stability {

namespace {

struct Place {
  glm::vec3 position{0}, normal{0, 1, 0}, eye{0, 3, 0};
  glm::vec3 diffuse{0.5f}, specular{0.5f};
  float exponent = 16;
};

Values numbers(const glm::vec3& v) {
  return values(v);
}

/// `count` lights of each kind, all of them the same: a metre above the position, shining straight down.
struct Lights {
  int count = 1;
  glm::vec3 above{0, 1, 0};  ///< where point and spot lights stand, from the position
  float colour = 1;
  glm::vec3 ambient{0.125f};
};

std::string call_of(const char* function) {
  return fmt::format("vec4({}(position.xyz, normal.xyz, eye.xyz, Material(kd.rgb, ks.rgb, ks.a)), 0.0)", function);
}

ShaderFunction shade_function(const Place& place, const Lights& lights, bool point, bool spot, bool sun) {
  Variant variant;
  variant.point_lights = point ? lights.count : 0;
  variant.spot_lights = spot ? lights.count : 0;
  variant.directional_lights = sun ? lights.count : 0;
  ShaderFunction function = blinn_phong_function({"position", "normal", "eye", "kd", "ks"}, call_of("shade"), variant);
  function.uniforms["u_ambient"] = numbers(lights.ambient);
  const Values at = numbers(place.position + lights.above), colour(3, lights.colour);
  for (int i = 0; i < lights.count; ++i) {
    const auto set = [&](const std::string& list, const char* member, Values value) {
      function.uniforms[fmt::format("{}[{}].{}", list, i, member)] = std::move(value);
    };
    for (const std::string list : {"u_point_lights", "u_spot_lights"}) {
      set(list, "position", at);
      set(list, "colour", colour);
      set(list, "attenuation", {0, 0, 1});
    }
    set("u_spot_lights", "direction", {0, -1, 0});
    set("u_spot_lights", "cosines", {0.9, 0.8});
    set("u_directional_lights", "direction", {0, -1, 0});
    set("u_directional_lights", "colour", colour);
  }
  return function;
}

/// What reaches the place of the first light of each type, 0..1; of light i 1/(i + 1) of that.
struct Visible {
  double point = 1, spot = 1, directional = 1;
};

constexpr const char* shade_with_visibilities = R"(
uniform vec3 u_visible;
vec3 shade_visible(vec3 position, vec3 normal, vec3 eye, Material m) {
#if POINT_LIGHTS > 0
  for (int i = 0; i < POINT_LIGHTS; ++i) point_visibility[i] = u_visible.x / float(i + 1);
#endif
#if SPOT_LIGHTS > 0
  for (int i = 0; i < SPOT_LIGHTS; ++i) spot_visibility[i] = u_visible.y / float(i + 1);
#endif
#if DIRECTIONAL_LIGHTS > 0
  for (int i = 0; i < DIRECTIONAL_LIGHTS; ++i) directional_visibility[i] = u_visible.z / float(i + 1);
#endif
  return shade(position, normal, eye, m);
}
)";

class Shade {
 public:
  explicit Shade(ShaderFunctions& shaders) : shaders_(&shaders) {}
  glm::dvec3 operator()(const Place& p, const Lights& lights, bool point = true, bool spot = true,
                        bool sun = true) const {
    return evaluate(shade_function(p, lights, point, spot, sun), p);
  }
  glm::dvec3 operator()(const Place& p, const Lights& lights, const Visible& visible) const {
    ShaderFunction function = shade_function(p, lights, true, true, true);
    function.defines.emplace("VISIBILITY", "1");
    function.source += shade_with_visibilities;
    function.expression = call_of("shade_visible");
    function.uniforms["u_visible"] = {visible.point, visible.spot, visible.directional};
    return evaluate(function, p);
  }

 private:
  glm::dvec3 evaluate(const ShaderFunction& function, const Place& p) const {
    return glm::dvec3(shaders_->evaluate(
        function, input_of(p.position, p.normal, p.eye, p.diffuse, glm::vec4(p.specular, p.exponent))));
  }
  ShaderFunctions* shaders_;
};

void add_light_count_rows(Group& group, const Shade& shade) {
  group.equals(
      "no light: ambient alone", [=] { return values(shade({}, {}, false, false, false)); }, Values(3, 0.0625));
  // One light gives kd + ks = 1 straight on: every sum here is exact in floats.
  group.equals(
      "one light of each kind", [=] { return values(shade({}, {})); }, Values(3, 3.0625));
  group.equals(
      "64 point lights", [=] { return values(shade({}, {.count = 64}, true, false, false)); }, Values(3, 64.0625));
  group.equals(
      "64 spot lights", [=] { return values(shade({}, {.count = 64}, false, true, false)); }, Values(3, 64.0625));
  group.equals(
      "64 directional lights", [=] { return values(shade({}, {.count = 64}, false, false, true)); },
      Values(3, 64.0625));
  group.equals(
      "16 of each kind", [=] { return values(shade({}, {.count = 16})); }, Values(3, 48.0625));
}

void add_degenerate_rows(Group& group, const Shade& shade) {
  const Values ambient(3, 0.0625);
  group.equals(
      "no normal: ambient alone",
      [=] {
        return values(shade({.normal = {0, 0, 0}}, {}));
      },
      ambient);
  group.equals(
      "the eye at the position: ambient alone",
      [=] {
        return values(shade({.eye = {0, 0, 0}}, {}));
      },
      ambient);
  group.equals(
      "point and spot light on the surface: ambient alone",
      [=] {
        return values(shade({}, {.above = {0, 0, 0}}, true, true, false));
      },
      ambient);
  group.finite("point and spot light a micrometre above the surface", [=] {
    return values(shade({}, {.above = {0, 1e-6f, 0}}, true, true, false));
  });
  group.equals(
      "lights below the surface: ambient alone",
      [=] {
        return values(shade({}, {.above = {0, -2, 0}}, true, true, false));
      },
      ambient);
  for (const float size : {1e-15f, 1e-3f, 1e3f, 1e15f})
    group.close(fmt::format("a normal {:g} long counts as a unit vector", size),
                {1e-5, "absolute", "a normalisation's 2 ulp, counted n = 16 times, in three lights"}, [=] {
                  return difference(values(shade({.normal = {0, size, 0}}, {})), Values(3, 3.0625));
                });
  for (const float size : {1e-20f, 1e-22f, 1e-30f, 1e20f, 1e30f})
    group.finite(fmt::format("a normal {:g} long, whose square is no float", size), [=] {
      return values(shade({.normal = {0, size, 0}}, {}));
    });
  for (const float size : {1e-20f, 1e-30f, 1e15f, 1e20f, 1e30f})
    group.finite(fmt::format("the eye {:g} m away", size), [=] { return values(shade({.eye = {0, size, 0}}, {})); });
  group.equals("black surface, black ambient",
               [=] {
                 return values(shade({.diffuse = {0, 0, 0}, .specular = {0, 0, 0}}, {}));
               },
               {0, 0, 0});
  group.close("lights of 1e6: nothing is clamped", {1e-6, "relative", "sums and products of floats"},
              [=] { return relative_difference(values(shade({}, {.colour = 1e6f})), Values(3, 3e6 + 0.0625)); });
  group.close("1e6 m from the origin, all of it moved alike",
              {1e-5, "absolute", "the differences of these floats are exact"}, [=] {
                const glm::vec3 far(1e6f, 1e6f, -1e6f);
                return difference(values(shade({.position = far, .eye = far + glm::vec3(0, 3, 0)}, {})),
                                  Values(3, 3.0625));
              });
  for (const float n : {0.0f, 1e6f})
    group.equals(
        fmt::format("an exponent of {:g}, straight on", n), [=] { return values(shade({.exponent = n}, {})); },
        Values(3, 3.0625));
}

/// All shares are powers of two: their sums are exact in floats.
void add_visibility_rows(Group& group, const Shade& shade) {
  const Values ambient(3, 0.0625);
  group.equals(
      "all of every light is visible", [=] { return values(shade({}, {}, Visible{})); }, Values(3, 3.0625));
  group.equals(
      "nothing of 16 lights of each kind is visible: ambient light is not lost",
      [=] {
        return values(shade({}, {.count = 16}, Visible{0, 0, 0}));
      },
      ambient);
  group.equals(
      "one half of each is visible",
      [=] {
        return values(shade({}, {}, Visible{0.5, 0.5, 0.5}));
      },
      Values(3, 1.5625));
  group.equals(
      "of each type another share",
      [=] {
        return values(shade({}, {}, Visible{1, 0.5, 0.125}));
      },
      Values(3, 1.6875));
  group.equals(
      "of two lights of each type other shares",
      [=] {
        return values(shade({}, {.count = 2}, Visible{1, 0.5, 0.25}));
      },
      Values(3, 2.6875));
  group.equals(
      "no normal, and one half is visible: ambient alone",
      [=] {
        return values(shade({.normal = {0, 0, 0}}, {}, Visible{0.5, 0.5, 0.5}));
      },
      ambient);
  group.equals(
      "point and spot light on the surface, and one half is visible: half of the directional light",
      [=] {
        return values(shade({}, {.above = {0, 0, 0}}, Visible{0.5, 0.5, 0.5}));
      },
      Values(3, 0.5625));
}

}  // namespace

void add_shade_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("shade (GLSL)");
  add_light_count_rows(group, Shade(shaders));
  add_degenerate_rows(group, Shade(shaders));
  add_visibility_rows(group, Shade(shaders));
}

}  // namespace atelier::stability
