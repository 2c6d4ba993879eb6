// shadow_factor: every bias with no normal, upon the light, at grazing light, on a map of one texel.
#include "stability/03-shadow-mapping/rows.hpp"

namespace atelier::stability {

using namespace shadow_mapping;

namespace {

struct Place {
  glm::vec3 position{0}, normal{0, 1, 0}, to_light{0, 1, 0};
};

/// A spot 4 m above the origin, over a map that is dark (0) or empty (1) everywhere.
class Factor {
 public:
  Factor(ShaderFunctions& shaders, const Variant& variant, float depth)
      : shaders_(&shaders), map_(std::make_shared<DepthMap>(shaders.gl(), std::initializer_list<float>{depth})) {
    const LightFrustum spot{.eye = {0, 4, 0}, .extent = 0.5f, .near = 0.5f, .far = 8};
    world_to_map_ = bias_matrix() * light_projection(spot) * light_view(spot);
    function_ = map_->read_by(shadow_function(
        {"m0", "m1", "m2", "m3", "p", "n", "l"},
        "vec4(shadow_factor(ShadowLight(mat4(m0, m1, m2, m3), vec3(0.0, 4.0, 0.0), vec3(0.0, -1.0, 0.0), 0.5463, 0.5, "
        "8.0, 0.5, false, 0), p.xyz, n.xyz, l.xyz))",
        variant));
    function_.uniforms = {{"u_bias", {1}}, {"u_depth_epsilon", {1e-6}}};
  }
  /// Of neighbouring pixels, so that derivatives are between them.
  Values operator()(const std::vector<Place>& places) const {
    std::vector<ShaderInput> inputs;
    for (const Place& p : places) inputs.push_back(input_of(world_to_map_, p.position, p.normal, p.to_light));
    return shaders_->numbers(function_, inputs);
  }

 private:
  ShaderFunctions* shaders_;
  std::shared_ptr<DepthMap> map_;
  glm::mat4 world_to_map_;
  ShaderFunction function_;
};

/// How many of the numbers are no share, 0..1.
Values no_shares(const Values& numbers) {
  return {count_outside(numbers, 0, 1)};
}

void add_factor_rows(Group& group, ShaderFunctions& shaders) {
  static constexpr const char* biases[] = {"no bias", "constant", "slope", "normal offset", "plane"};
  for (int bias = 0; bias <= 4; ++bias)
    for (const int samples : {0, 4}) {
      const Variant variant{.bias = bias, .pcf = 3, .samples = samples};
      const Factor dark(shaders, variant, 0), empty(shaders, variant, 1);
      const auto words = [&](const char* extreme) {
        return fmt::format("{}{}: {}", biases[bias], samples ? ", PCSS" : "", extreme);
      };
      group.equals(words("behind the light: lit"),
                   [=] {
                     return dark({{.position = {0, 6, 0}, .to_light = {0, -1, 0}},
                                  {.position = {1, 6, 0}, .to_light = {0, -1, 0}}});
                   },
                   {1, 1});
      group.equals(words("upon the light, which then lies no way: a share"),
                   [=] {
                     return no_shares(dark({{.position = {0, 4, 0}, .to_light = {0, 0, 0}}}));
                   },
                   {0});
      group.equals(words("an empty map, far beyond its far plane: lit"),
                   [=] {
                     return empty({{.position = {0, -50, 0}}, {.position = {0, -50, 0}}});
                   },
                   {1, 1});
      group.equals(words("no normal, grazing light, turned away, 1e30 m away: shares"),
                   [=] {
                     return no_shares(dark({{.normal = {0, 0, 0}},
                                            {.to_light = slanted(89.9)},
                                            {.to_light = slanted(90)},
                                            {.normal = {0, -1, 0}},
                                            {.normal = slanted(89.9)},
                                            {.position = {0, -1e30f, 0}},
                                            {.position = {1e30f, 0, 0}}}));
                   },
                   {0});
    }
}

}  // namespace

void add_factor_rows(Table& table, ShaderFunctions& shaders) {
  Group factor = table.of("shadow_factor (GLSL)");
  add_factor_rows(factor, shaders);
}

}  // namespace atelier::stability
