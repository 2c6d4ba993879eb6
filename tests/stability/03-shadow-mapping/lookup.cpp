// compare_depth and pcf: maps of one texel, points beside the map and beyond its far plane, depths that are equal.
#include "stability/03-shadow-mapping/rows.hpp"

namespace atelier::stability {

namespace {

/// One map, looked up by one call of (coordinate, slope).
class Lookup {
 public:
  Lookup(ShaderFunctions& shaders, std::initializer_list<float> depths, const Variant& variant, const char* call)
      : shaders_(&shaders),
        map_(std::make_shared<DepthMap>(shaders.gl(), depths, variant.compare)),
        function_(map_->read_by(shadow_function({"at", "slope"}, fmt::format("vec4({})", call), variant))) {}
  Values operator()(const glm::vec3& at, const glm::vec2& slope = {}) const {
    return {shaders_->number(function_, input_of(at, slope))};
  }

 private:
  ShaderFunctions* shaders_;
  std::shared_ptr<DepthMap> map_;
  ShaderFunction function_;
};

void add_comparison_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("compare_depth (GLSL)");
  for (const bool compare : {false, true}) {
    const char* how = compare ? "compared by the sampler" : "compared by the shader";
    const Variant variant{.compare = compare};
    const Lookup one(shaders, {0.5f}, variant, "compare_depth(at.xyz, 0)");
    const auto words = [how](const char* extreme) { return fmt::format("{}: {}", how, extreme); };
    group.equals(words("a map of one texel, before and behind what it holds"),
                 [=] {
                   return Values{one({0.5f, 0.5f, 0.4f})[0], one({0.5f, 0.5f, 0.6f})[0]};
                 },
                 {1, 0});
    group.equals(words("the very depth that is stored is lit"), [=] { return one({0.5f, 0.5f, 0.5f}); }, {1});
    group.equals(words("beside the map"),
                 [=] {
                   return Values{one({-1, 0.5f, 0.9f})[0], one({0.5f, 1e6f, 0.9f})[0]};
                 },
                 {1, 1});
    group.equals(words("behind the light: z = 2"), [=] { return one({0, 0, 2}); }, {1});
    group.equals(words("before the near plane"), [=] { return one({0.5f, 0.5f, -1e6f}); }, {1});
    const Lookup empty(shaders, {1, 1, 1, 1}, variant, "compare_depth(at.xyz, 0)");
    group.equals(words("nothing in the map, a point beyond the far plane"),
                 [=] {
                   return empty({0.3f, 0.7f, 1});
                 },
                 {1});
    group.finite(words("a coordinate 1e30 maps away"), [=] { return one({1e30f, -1e30f, 0.5f}); });
  }
  const Lookup halves(shaders, {0.25f, 0.75f, 0.25f, 0.75f}, {.compare = true}, "compare_depth(at.xyz, 0)");
  group.close("mixed halfway between a lit and a dark texel",
              {1.0 / 256, "absolute", "drivers mix texels by weights of at least 8 bits"}, [=] {
                return std::abs(halves({0.5f, 0.5f, 0.5f})[0] - 0.5);
              });
}

void add_pcf_rows(Table& table, ShaderFunctions& shaders) {
  Group group = table.of("pcf (GLSL)");
  const char* call = "pcf(at.xyz, slope.xy, 0)";
  for (const int width : {1, 2, 15}) {
    const Lookup one(shaders, {0.5f}, {.pcf = width}, call);
    group.close(fmt::format("{0} x {0} over a map of one texel: all others are lit", width),
                {4 * rounding_unit, "absolute", "a sum of ones, exact, and one quotient"}, [=] {
                  // The middle texel alone is in shadow; between two texels, one of the four.
                  return std::abs(one({0.6f, 0.6f, 0.75f})[0] - (1 - 1.0 / (width * width)));
                });
  }
  const Lookup dark(shaders, {0, 0, 0, 0}, {.pcf = 15}, call), wide(shaders, {0.5f}, {.pcf = 15}, call);
  group.equals("behind the light: z = 2", [=] { return wide({0, 0, 2}); }, {1});
  group.equals("1e6 maps beside the map", [=] { return dark({1e6f, 1e6f, 0.5f}); }, {1});
  group.equals("a plane that rises a hundredfold across the map: part lit, part dark, all counted",
               [=] {
                 const double share = wide({0.5f, 0.5f, 0.5f}, {100, -100})[0];
                 return Values{double(share >= 0 && share <= 1)};
               },
               {1});
  group.equals("the plane's slope reaches the comparison: behind on one side only",
               [&shaders, call] {
                 const Lookup flat(shaders, {0.5f, 0.5f, 0.5f, 0.5f}, {.pcf = 2}, call);
                 return flat({0.5f, 0.5f, 0.5f}, {0.1f, 0});
               },
               {0.5});
}

}  // namespace

void add_lookup_rows(Table& table, ShaderFunctions& shaders) {
  add_comparison_rows(table, shaders);
  add_pcf_rows(table, shaders);
}

}  // namespace atelier::stability
