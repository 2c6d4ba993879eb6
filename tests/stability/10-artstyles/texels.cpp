#include "stability/10-artstyles/texels.hpp"

namespace atelier::stability {

Texels random_texels(int width, int height, double low, double high) {
  Texels texels(width, height);
  for (std::size_t i = 0; i < texels.colours.size(); ++i) {
    Trial t(1100, std::int64_t(i));
    const double r = t.between(low, high), g = t.between(low, high);
    texels.colours[i] = glm::vec4(r, g, t.between(low, high), 1);
  }
  return texels;
}

Texels coordinate_texels(int axis) {
  Texels texels(coordinate_side, coordinate_side);
  for (int y = 0; y < coordinate_side; ++y)
    for (int x = 0; x < coordinate_side; ++x)
      texels.at(x, y) = glm::vec4(glm::vec3((float(axis == 0 ? x : y) + 0.5f) / coordinate_side), 1);
  return texels;
}

double read_coordinate(double texcoord) {
  return std::clamp(texcoord, 0.5 / coordinate_side, 1 - 0.5 / coordinate_side);
}

std::vector<glm::vec4> results_with(ShaderFunctions& shaders, const Texels& texels, bool linear,
                                    std::vector<std::string> parameters, std::string expression,
                                    const std::vector<ShaderInput>& calls) {
  Gl& gl = shaders.gl();
  const GlTexture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, texels.width, texels.height, 0, GL_RGBA, GL_FLOAT, texels.colours.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, linear ? GL_LINEAR : GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  ShaderFunction function =
      style_function(std::move(parameters), std::move(expression), "uniform sampler2D u_texels;\n");
  function.textures = {{"u_texels", texture.id()}};
  return results_of(shaders, function, calls);
}

}  // namespace atelier::stability
