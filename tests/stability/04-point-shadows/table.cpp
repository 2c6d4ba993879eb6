// Step 04's table of extremes.
#include <fmt/format.h>

#include "stability/04-point-shadows/rows.hpp"
#include "stability/entry.hpp"

namespace atelier::stability {

FilledCube::FilledCube(Gl& gl, int resolution, GLenum format, bool compare, const std::array<float, 6>& faces)
    : names_(point_shadows::make_cube_map(gl, resolution, format, compare)),
      texture_(gl, names_.texture),
      framebuffer_(gl, names_.framebuffer) {
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, texture_.id());
  for (int face = 0; face < 6; ++face) {
    const std::vector<float> texels(std::size_t(resolution) * std::size_t(resolution), faces[std::size_t(face)]);
    gl.TexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GLint(format), resolution, resolution, 0,
                  GL_DEPTH_COMPONENT, GL_FLOAT, texels.data());
  }
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
}

ShaderFunction lookup_function(std::vector<std::string> parameters, std::string expression, const Lookup& lookup) {
  ShaderFunction function{"#include \"04-point-shadows/point_shadows.glsl\"\n", std::move(parameters),
                          std::move(expression)};
  function.defines = {{"POINT_LIGHTS", "0"},
                      {"SPOT_LIGHTS", "0"},
                      {"DIRECTIONAL_LIGHTS", "0"},
                      {"SHADOW_LIGHTS", "0"},
                      {"CUBES", "1"},
                      {"BIAS", fmt::to_string(lookup.bias)},
                      {"PCF", fmt::to_string(lookup.pcf)}};
  if (lookup.compare) function.defines.emplace("COMPARE", "1");
  return function;
}

std::vector<glm::vec3> directions_near_edges(float off) {
  std::vector<glm::vec3> places;
  for (int along = 0; along < 3; ++along)
    for (const float a : {-1.0f, 1.0f})
      for (const float b : {-1.0f, 1.0f})
        for (const float t : {-1.0f, -0.9f, -0.3f, 0.0f, 0.5f, 0.7f, 1.0f}) {
          glm::vec3 place(t);
          place[(along + 1) % 3] = a;
          place[(along + 2) % 3] = b;
          places.push_back(place);
        }
  std::vector<glm::vec3> directions;
  for (const glm::vec3& place : places)
    for (int i = 0; i < 9; ++i) {
      // Moves that part its components, one up and one down and the reverse.
      const glm::vec3 move(float(i % 3 - 1), float(i / 3 - 1), float((i + i / 3) % 3 - 1));
      directions.push_back(place + off * move);
    }
  return directions;
}

}  // namespace atelier::stability

void atelier_stability_table(atelier::stability::Table& table, atelier::stability::ShaderFunctions& shaders) {
  using namespace atelier::stability;
  add_face_rows(table);
  add_cone_rows(table);
  add_cube_rows(table, shaders);
  add_drawing_rows(table, shaders);
  add_lookup_rows(table, shaders);
  add_factor_rows(table, shaders);
}
