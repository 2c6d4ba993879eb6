// Step 08's table of extremes.
#include "stability/08-post-processing/rows.hpp"
#include "stability/entry.hpp"

namespace atelier::stability {

ShaderFunction post_function(std::vector<std::string> parameters, std::string expression, const std::string& helpers) {
  return {text_including("08-post-processing/post_processing.glsl") + helpers, std::move(parameters),
          std::move(expression)};
}

Values colours_of(ShaderFunctions& shaders, const ShaderFunction& function, const std::vector<ShaderInput>& inputs) {
  Values out;
  for (const glm::vec4& v : shaders.evaluate(function, inputs)) {
    const Values colour = values(glm::vec3(v));
    out.insert(out.end(), colour.begin(), colour.end());
  }
  return out;
}

}  // namespace atelier::stability

void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders) {
  using namespace atelier::stability;
  add_target_rows(table);
  add_full_screen_rows(table, shaders);
  add_passes_rows(table);
  add_luma_rows(table, shaders);
  add_parts_rows(table, shaders);
  add_colour_rows(table, shaders);
  add_round_trip_rows(table, shaders);
  add_adjusted_rows(table, shaders);
  add_reinhard_rows(table, shaders);
  add_filmic_rows(table, shaders);
  add_tone_rows(table, shaders);
  add_overlaid_rows(table, shaders);
  add_bright_rows(table, shaders);
  add_weights_rows(table);
  add_blurred_rows(table, shaders);
  add_lookup_rows(table, shaders);
  add_dithered_rows(table, shaders);
  add_read_rows(table);
  add_write_rows(table);
}
