// Step 09's table of extremes.
#include "stability/09-dithering/rows.hpp"
#include "stability/entry.hpp"

namespace atelier::stability {

ShaderFunction dither_function(std::vector<std::string> parameters, std::string expression) {
  return {text_including("09-dithering/dithering.glsl"), std::move(parameters), std::move(expression)};
}

Values numbers_of_calls(ShaderFunctions& shaders, const ShaderFunction& function,
                        const std::vector<ShaderInput>& inputs) {
  constexpr std::size_t in_one_draw = 16384;
  Values out;
  for (std::size_t from = 0; from < inputs.size(); from += in_one_draw) {
    const auto first = inputs.begin() + std::ptrdiff_t(from);
    const auto count = std::ptrdiff_t(std::min(in_one_draw, inputs.size() - from));
    const Values some = shaders.numbers(function, {first, first + count});
    out.insert(out.end(), some.begin(), some.end());
  }
  return out;
}

}  // namespace atelier::stability

void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders) {
  using namespace atelier::stability;
  add_bayer_rows(table);
  add_threshold_rows(table, shaders);
  add_level_rows(table, shaders);
  add_shares_rows(table);
  add_diffused_rows(table);
  add_diffused_exactly_rows(table);
  add_place_rows(table, shaders);
  add_edge_rows(table, shaders);
  add_noise_rows(table);
  add_bitmap_rows(table);
  add_octave_rows(table, shaders);
  add_surface_rows(table, shaders);
  add_mixed_rows(table, shaders);
  add_fast_rows(table);
}
