// Step 02's table of extremes.
#include "stability/02-blinn-phong/rows.hpp"
#include "stability/entry.hpp"

namespace atelier::stability {

ShaderFunction blinn_phong_function(std::vector<std::string> parameters, std::string expression, const Variant& variant,
                                    const std::string& helpers) {
  ShaderFunction function{text_including("02-blinn-phong/blinn_phong.glsl") + helpers, std::move(parameters),
                          std::move(expression)};
  function.defines = {{"POWER", fmt::to_string(variant.power)},
                      {"NORMALISATION", fmt::to_string(variant.normalisation)},
                      {"POINT_LIGHTS", fmt::to_string(variant.point_lights)},
                      {"SPOT_LIGHTS", fmt::to_string(variant.spot_lights)},
                      {"DIRECTIONAL_LIGHTS", fmt::to_string(variant.directional_lights)}};
  if (variant.specular) function.defines.emplace("SPECULAR", "1");
  return function;
}

}  // namespace atelier::stability

void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders) {
  using namespace atelier::stability;
  add_colour_rows(table, shaders);
  add_texture_rows(table, shaders);
  add_energy_rows(table, shaders);
  add_light_rows(table, shaders);
  add_highlight_rows(table, shaders);
  add_reflected_rows(table, shaders);
  add_shade_rows(table, shaders);
}
