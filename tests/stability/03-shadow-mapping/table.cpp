// Step 03's table of extremes.
#include <fmt/format.h>

#include <cmath>

#include "stability/03-shadow-mapping/rows.hpp"
#include "stability/entry.hpp"

namespace atelier::stability {

ShaderFunction shadow_function(std::vector<std::string> parameters, std::string expression, const Variant& variant) {
  ShaderFunction function{"#include \"03-shadow-mapping/shadow_mapping.glsl\"\n", std::move(parameters),
                          std::move(expression)};
  function.defines = {{"POWER", "0"},
                      {"NORMALISATION", "0"},
                      {"POINT_LIGHTS", "0"},
                      {"SPOT_LIGHTS", "0"},
                      {"DIRECTIONAL_LIGHTS", "0"},
                      {"SHADOW_LIGHTS", "0"},
                      {"BIAS", fmt::to_string(variant.bias)},
                      {"PCF", fmt::to_string(variant.pcf)}};
  if (variant.compare) function.defines.emplace("COMPARE", "1");
  if (variant.samples > 0) {
    function.defines.emplace("PCSS", "1");
    function.defines.emplace("SAMPLES", fmt::to_string(variant.samples));
  }
  if (variant.random) function.defines.emplace("RANDOM", "1");
  return function;
}

DepthMap::DepthMap(Gl& gl, std::initializer_list<float> depths, bool compare) : texture_(gl) {
  const GLsizei side = GLsizei(std::lround(std::sqrt(double(depths.size()))));
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture_.id());
  gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, side, side, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                std::data(depths));
  const GLint filter = compare ? GL_LINEAR : GL_NEAREST;
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, name, filter);
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, name, GL_CLAMP_TO_BORDER);
  const glm::vec4 farthest(1);
  gl.TexParameterfv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BORDER_COLOR, &farthest[0]);
  gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, compare ? GL_COMPARE_REF_TO_TEXTURE : GL_NONE);
  gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, 0);
}

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
