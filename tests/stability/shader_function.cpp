#include "stability/shader_function.hpp"

#include <fmt/format.h>

#include "gl/full_screen.hpp"
#include "gl/target.hpp"

namespace atelier::stability {

namespace {

/// The fragment shader of a picture one pixel high, a pixel an input: parameter k of the input at pixel x is texel (x,
/// k).
std::string fragment_text(const ShaderFunction& function) {
  std::string text = function.source + "\nuniform sampler2D u_inputs;\nout vec4 o_value;\nvoid main() {\n";
  for (std::size_t k = 0; k < function.parameters.size(); ++k)
    text += fmt::format("  vec4 {} = texelFetch(u_inputs, ivec2(int(gl_FragCoord.x), {}), 0);\n",
                        function.parameters[k], k);
  return text + "  o_value = " + function.expression + ";\n}\n";
}

/// The inputs as the texels of a picture, parameter by parameter.
std::vector<glm::vec4> texels_of(const ShaderFunction& function, const std::vector<ShaderInput>& inputs) {
  std::vector<glm::vec4> texels(inputs.size() * function.parameters.size());
  for (std::size_t x = 0; x < inputs.size(); ++x) {
    if (inputs[x].size() != function.parameters.size())
      throw Error(fmt::format("{}: an input of {} values for {} parameters", function.expression, inputs[x].size(),
                              function.parameters.size()));
    for (std::size_t k = 0; k < inputs[x].size(); ++k) texels[k * inputs.size() + x] = inputs[x][k];
  }
  return texels;
}

void set_uniform(Uniforms& uniforms, const std::string& name, const Values& v) {
  switch (v.size()) {
    case 1:
      return uniforms.set(name, float(v[0]));
    case 2:
      return uniforms.set(name, glm::vec2(v[0], v[1]));
    case 3:
      return uniforms.set(name, glm::vec3(v[0], v[1], v[2]));
    case 4:
      return uniforms.set(name, glm::vec4(v[0], v[1], v[2], v[3]));
    case 16: {
      glm::mat4 matrix;
      for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = float(v[std::size_t(i)]);
      return uniforms.set(name, matrix);
    }
    default:
      throw Error(fmt::format("uniform {}: {} values, where 1 to 4 or 16 are possible", name, v.size()));
  }
}

}  // namespace

GLuint ShaderFunctions::program_for(const ShaderFunction& function) {
  const std::string text = fragment_text(function);
  std::string key = text;
  for (const auto& [name, value] : function.defines) key += fmt::format("#define {} {}\n", name, value);
  auto found = programs_.find(key);
  if (found == programs_.end()) {
    const ShaderSource vertex = assemble_shader_text(find_, full_screen_vertex_text, "vertex shader", {});
    const ShaderSource fragment = assemble_shader_text(find_, text, function.expression, function.defines);
    found = programs_.emplace(std::move(key), build_program(*gl_, vertex, fragment)).first;
  }
  return found->second.id();
}

GLuint ShaderFunctions::pipeline(const std::string& vertex, const std::string& geometry, const std::string& fragment) {
  const std::string key = vertex + geometry + fragment;
  auto found = programs_.find(key);
  if (found == programs_.end()) {
    const auto stage = [&](const std::string& text, const char* label) {
      return assemble_shader_text(find_, text, label, {});
    };
    const ShaderSource middle = stage(geometry, "geometry shader");
    found = programs_
                .emplace(key, build_program(*gl_, stage(vertex, "vertex shader"), stage(fragment, "fragment shader"),
                                            &middle))
                .first;
  }
  return found->second.id();
}

std::vector<glm::vec4> ShaderFunctions::evaluate(const ShaderFunction& function,
                                                 const std::vector<ShaderInput>& inputs) {
  Gl& gl = *gl_;
  const GLsizei count = GLsizei(inputs.size());
  const std::vector<glm::vec4> texels = texels_of(function, inputs);
  const GLuint program = program_for(function);

  // The target checks the number of inputs: it is its width.
  const Target target(gl, {.width = count, .height = 1, .colour = ColourFormat::rgba32f, .depth = DepthFormat::none});
  const GlTexture input_texture(gl);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, input_texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, count, GLsizei(function.parameters.size()), 0, GL_RGBA, GL_FLOAT,
                texels.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);

  target.bind(gl);
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_CULL_FACE);
  gl.Disable(GL_BLEND);
  gl.UseProgram(program);
  Uniforms uniforms(gl, program);
  uniforms.set("u_inputs", 0);
  for (const auto& [name, value] : function.uniforms) set_uniform(uniforms, name, value);
  int unit = 0;
  const auto bind = [&](GLenum kind, const std::map<std::string, GLuint>& textures) {
    for (const auto& [name, texture] : textures) {
      gl.ActiveTexture(GLenum(GL_TEXTURE0 + ++unit));
      gl.BindTexture(kind, texture);
      uniforms.set(name, unit);
    }
  };
  bind(GL_TEXTURE_2D, function.textures);
  bind(GL_TEXTURE_2D_ARRAY, function.arrays);
  bind(GL_TEXTURE_CUBE_MAP, function.cubes);
  gl.ActiveTexture(GL_TEXTURE0);
  draw_triangle_by_id(gl);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  check_gl_error(gl, function.expression.c_str());

  const Image result = target.read_colour(gl);
  std::vector<glm::vec4> out;
  for (const Rgba& p : result.pixels()) out.emplace_back(p.r, p.g, p.b, p.a);
  return out;
}

glm::vec4 ShaderFunctions::evaluate(const ShaderFunction& function, const ShaderInput& input) {
  return evaluate(function, std::vector<ShaderInput>{input}).front();
}

Values ShaderFunctions::numbers(const ShaderFunction& function, const std::vector<ShaderInput>& inputs) {
  Values out;
  for (const glm::vec4& v : evaluate(function, inputs)) out.push_back(double(v.x));
  return out;
}

double ShaderFunctions::number(const ShaderFunction& function, const ShaderInput& input) {
  return double(evaluate(function, input).x);
}

}  // namespace atelier::stability
