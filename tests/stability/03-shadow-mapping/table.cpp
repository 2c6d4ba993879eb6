// Step 03's table of extremes.
#include "03-shadow-mapping/given/shaders_alone.hpp"
#include "gl/depth_textures.hpp"
#include "stability/03-shadow-mapping/rows.hpp"
#include "stability/entry.hpp"

namespace atelier::stability {

ShaderFunction shadow_function(std::vector<std::string> parameters, std::string expression, const Variant& variant) {
  ShaderFunction function{text_including("03-shadow-mapping/shadow_mapping.glsl"), std::move(parameters),
                          std::move(expression), no_shadow_lights()};
  function.defines.merge(Defines{{"POWER", "0"},
                                 {"NORMALISATION", "0"},
                                 {"BIAS", fmt::to_string(variant.bias)},
                                 {"PCF", fmt::to_string(variant.pcf)}});
  if (variant.compare) function.defines.emplace("COMPARE", "1");
  if (variant.samples > 0) {
    function.defines.emplace("PCSS", "1");
    function.defines.emplace("SAMPLES", fmt::to_string(variant.samples));
  }
  if (variant.random) function.defines.emplace("RANDOM", "1");
  return function;
}

DepthMap::DepthMap(Gl& gl, std::initializer_list<float> depths, bool compare)
    : texture_(make_depth_layers(gl, int(std::lround(std::sqrt(double(depths.size())))), depths, compare)) {}

ShaderFunction DepthMap::read_by(ShaderFunction function) const {
  function.arrays["u_shadow_maps"] = texture_.id();
  return function;
}

}  // namespace atelier::stability

// make_shadow_maps and begin_depth_pass only tell OpenGL what to do: their probes read all of it back.
void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders) {
  using namespace atelier::stability;
  add_fit_rows(table);
  add_matrix_rows(table, shaders);
  add_snap_rows(table);
  add_coordinate_rows(table, shaders);
  add_bias_rows(table, shaders);
  add_lookup_rows(table, shaders);
  add_soft_rows(table, shaders);
  add_factor_rows(table, shaders);
}
