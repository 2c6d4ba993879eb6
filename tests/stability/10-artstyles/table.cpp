// Step 10's table of extremes.
#include "02-blinn-phong/given/shaders_alone.hpp"
#include "stability/10-artstyles/rows.hpp"
#include "stability/entry.hpp"

namespace atelier::stability {

ShaderFunction style_function(std::vector<std::string> parameters, std::string expression, const std::string& helpers) {
  return {text_including("10-artstyles/artstyles.glsl", no_lights()) + helpers, std::move(parameters),
          std::move(expression)};
}

std::vector<glm::vec4> results_of(ShaderFunctions& shaders, const ShaderFunction& function,
                                  const std::vector<ShaderInput>& inputs) {
  constexpr std::size_t in_one_draw = 16384;
  std::vector<glm::vec4> out;
  for (std::size_t from = 0; from < inputs.size(); from += in_one_draw) {
    const auto first = inputs.begin() + std::ptrdiff_t(from);
    const auto count = std::ptrdiff_t(std::min(in_one_draw, inputs.size() - from));
    const std::vector<glm::vec4> some = shaders.evaluate(function, std::vector<ShaderInput>(first, first + count));
    out.insert(out.end(), some.begin(), some.end());
  }
  return out;
}

double worst_result(ShaderFunctions& shaders, const ShaderFunction& function, const std::vector<ShaderInput>& calls,
                    const std::function<double(const ShaderInput&, const glm::vec4&)>& error) {
  const std::vector<glm::vec4> found = results_of(shaders, function, calls);
  double worst = 0;
  for (std::size_t i = 0; i < calls.size(); ++i) worst = worse_of(worst, error(calls[i], found[i]));
  return worst;
}

double count_failed(ShaderFunctions& shaders, const ShaderFunction& function, const std::vector<ShaderInput>& calls,
                    const std::function<double(const ShaderInput&, const glm::vec4&)>& error) {
  const std::vector<glm::vec4> found = results_of(shaders, function, calls);
  double failed = 0;
  for (std::size_t i = 0; i < calls.size(); ++i) failed += !(error(calls[i], found[i]) <= 1);
  return failed;
}

std::vector<glm::dvec2> polar_grid(double farthest) {
  constexpr int directions = 146, distances = 84;
  std::vector<glm::dvec2> grid;
  for (int j = 0; j < distances; ++j)
    for (int i = 0; i < directions; ++i)
      grid.emplace_back(farthest * (j + 0.5) / distances, 2 * std::numbers::pi * i / directions);
  return grid;
}

glm::vec2 texcoord_of(const glm::dvec2& place, const glm::vec2& size) {
  return glm::vec2(0.5 + 0.5 * place * glm::dvec2(double(size.y) / double(size.x), 1));
}

glm::dvec2 place_of(const glm::vec2& texcoord, const glm::vec2& size) {
  return (2.0 * glm::dvec2(texcoord) - 1.0) * glm::dvec2(double(size.x) / double(size.y), 1);
}

double texcoord_rounding(const glm::vec2& texcoord, const glm::vec2& size) {
  const glm::dvec2 each = glm::max(glm::abs(glm::dvec2(texcoord)), 1.0) * rounding_unit;
  return 2 * glm::length(each * glm::dvec2(double(size.x) / double(size.y), 1));
}

double pow_error(double base, double exponent) {
  if (base == 0) return 0;
  const double log = std::log2(base), x = exponent * log;
  const double off = exponent * std::max(0x1p-21, 6 * rounding_unit * std::abs(log)) + 2 * rounding_unit * std::abs(x);
  return std::expm1(std::numbers::ln2 * off) + 2 * (3 + 2 * std::abs(x)) * rounding_unit;
}

}  // namespace atelier::stability

void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders) {
  using namespace atelier::stability;
  add_edge_rows(table, shaders);
  add_toon_rows(table, shaders);
  add_steps_rows(table, shaders);
  add_power_source_rows(table, shaders);
  add_direction_rows(table, shaders);
  add_in_direction_rows(table, shaders);
  add_aberrated_rows(table, shaders);
  add_centres_rows(table);
  add_radius_rows(table);
  add_stroke_rows(table);
  add_fisheye_place_rows(table, shaders);
  add_power_place_rows(table, shaders);
  add_regions_rows(table);
  add_distorted_rows(table, shaders);
}
