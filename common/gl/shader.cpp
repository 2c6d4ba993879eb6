#include "gl/shader.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace atelier {
namespace {

/// The driver's log for a shader or a program; `get_iv` and `get_log` are the matching functions.
template <class GetIv, class GetLog>
std::string info_log(GLuint object, const GetIv& get_iv, const GetLog& get_log) {
  GLint length = 0;
  get_iv(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(std::max(length, 1)), '\0');
  GLsizei written = 0;
  get_log(object, length, &written, log.data());
  log.resize(std::size_t(std::max(written, 0)));
  return log;
}

GlShader compile(Gl& gl, GLenum stage, const ShaderSource& source) {
  GlShader shader(gl, gl.CreateShader(stage));
  const GLchar* text = source.text.data();
  const auto length = GLint(source.text.size());
  gl.ShaderSource(shader.id(), 1, &text, &length);
  gl.CompileShader(shader.id());
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled) return shader;

  const std::string log = translate_shader_log(info_log(shader.id(), gl.GetShaderiv, gl.GetShaderInfoLog), source);
  throw ShaderError(log.empty() ? source.names.front() + ": error: the driver rejects this shader without a reason"
                                : log);
}

}  // namespace

GlProgram build_program(Gl& gl, const ShaderSource& vertex, const ShaderSource& fragment,
                        const ShaderSource* geometry) {
  std::vector<GlShader> shaders;
  shaders.push_back(compile(gl, GL_VERTEX_SHADER, vertex));
  if (geometry) shaders.push_back(compile(gl, GL_GEOMETRY_SHADER, *geometry));
  shaders.push_back(compile(gl, GL_FRAGMENT_SHADER, fragment));

  GlProgram program(gl);
  for (const GlShader& shader : shaders) gl.AttachShader(program.id(), shader.id());
  gl.LinkProgram(program.id());
  for (const GlShader& shader : shaders) gl.DetachShader(program.id(), shader.id());  // so that they are freed now
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  if (linked) return program;

  // A linker message concerns both stages: it names a variable, but no line.
  const std::string log = translate_shader_log(info_log(program.id(), gl.GetProgramiv, gl.GetProgramInfoLog), fragment);
  throw ShaderError(fmt::format("{} and {} do not link:\n{}", vertex.names.front(), fragment.names.front(),
                                log.empty() ? "the driver gives no reason" : log));
}

}  // namespace atelier
