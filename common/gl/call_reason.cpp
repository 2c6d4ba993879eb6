#include "gl/call_reason.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/gl_enum_name.hpp"
#include "gl/gl.hpp"
#include "gl/query.hpp"

namespace atelier {
namespace {

double argument(const GlFailedCall& call, std::size_t place) {
  return place < call.arguments.size() ? call.arguments[place].value : 0;
}

/// The first argument that its parameter does not allow.
std::string refused_enum(const GlFailedCall& call) {
  for (const GlParameter& parameter : enum_parameters(call.function, call.arguments)) {
    const double given = argument(call, parameter.place);
    if (std::find(parameter.allowed.begin(), parameter.allowed.end(), GLenum(given)) != parameter.allowed.end())
      continue;
    const std::string allowed = allowed_in_words(parameter), name = enum_in_words(parameter, given);
    // There are more than are listed.
    if (parameter.name == "internal format" && name.starts_with("0x")) continue;
    // The value of a texture's parameter: the parameter says what it is.
    if (parameter.name.starts_with("GL_"))
      return fmt::format("{} is no {}, which takes {}", name, parameter.name, allowed);
    return fmt::format("{} is no {} of gl{}, which takes {}", name, parameter.name, call.function, allowed);
  }
  return {};
}

std::string draw_reason(const Gl& gl, const GlFailedCall& call) {
  if (call.error == GL_INVALID_FRAMEBUFFER_OPERATION) {
    const GLenum status = gl.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return {};
    return fmt::format("the bound framebuffer {} is not complete: {}", integer_of(gl, GL_DRAW_FRAMEBUFFER_BINDING),
                       gl_enum_name(status));
  }
  if (call.error != GL_INVALID_OPERATION) return {};
  if (integer_of(gl, GL_VERTEX_ARRAY_BINDING) == 0) return "no vertex array is bound: call glBindVertexArray before";
  if (call.function == "DrawElements" && integer_of(gl, GL_ELEMENT_ARRAY_BUFFER_BINDING) == 0)
    return "the vertex array has no GL_ELEMENT_ARRAY_BUFFER";
  return {};
}

std::string attribute_reason(const Gl& gl, const GlFailedCall& call) {
  const double size = argument(call, 1);
  if (call.error == GL_INVALID_VALUE && (size < 1 || size > 4))
    return fmt::format("an attribute of {} components is not possible: it takes 1, 2, 3 or 4", size);
  if (call.error != GL_INVALID_OPERATION) return {};
  if (integer_of(gl, GL_VERTEX_ARRAY_BINDING) == 0) return "no vertex array is bound: call glBindVertexArray before";
  if (integer_of(gl, GL_ARRAY_BUFFER_BINDING) == 0) return "no GL_ARRAY_BUFFER is bound: call glBindBuffer before";
  return {};
}

struct UniformType {
  GLenum type;
  const char *name, *suffix;  ///< in GLSL; of the function that sets it
};

constexpr std::array uniform_types = {UniformType{GL_FLOAT, "float", "1f"},
                                      UniformType{GL_FLOAT_VEC2, "vec2", "2f"},
                                      UniformType{GL_FLOAT_VEC3, "vec3", "3fv"},
                                      UniformType{GL_FLOAT_VEC4, "vec4", "4fv"},
                                      UniformType{GL_INT, "int", "1i"},
                                      UniformType{GL_BOOL, "bool", "1i"},
                                      UniformType{GL_FLOAT_MAT3, "mat3", "Matrix3fv"},
                                      UniformType{GL_FLOAT_MAT4, "mat4", "Matrix4fv"},
                                      UniformType{GL_SAMPLER_2D, "sampler2D", "1i"},
                                      UniformType{GL_SAMPLER_2D_ARRAY, "sampler2DArray", "1i"},
                                      UniformType{GL_SAMPLER_2D_SHADOW, "sampler2DShadow", "1i"},
                                      UniformType{GL_SAMPLER_2D_ARRAY_SHADOW, "sampler2DArrayShadow", "1i"},
                                      UniformType{GL_SAMPLER_CUBE, "samplerCube", "1i"}};

std::string uniform_reason(const Gl& gl, const GlFailedCall& call) {
  const auto program = GLuint(integer_of(gl, GL_CURRENT_PROGRAM));
  if (program == 0) return "no program is in use: call glUseProgram before";
  const auto location = GLint(argument(call, 0));
  GLint uniforms = 0;
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORMS, &uniforms);
  for (GLint i = 0; i < uniforms; ++i) {
    std::array<GLchar, 256> name{};
    GLint elements = 0;
    GLenum type = GL_NONE;
    gl.GetActiveUniform(program, GLuint(i), GLsizei(name.size()), nullptr, &elements, &type, name.data());
    const GLint first = gl.GetUniformLocation(program, name.data());
    if (first < 0 || location < first || location >= first + elements) continue;
    for (const UniformType& known : uniform_types)
      if (known.type == type)
        return fmt::format("{} is a {}, which glUniform{} sets", name.data(), known.name, known.suffix);
  }
  return fmt::format("the program in use has no uniform at location {}", location);
}

std::string attachment_reason(const Gl& gl, const GlFailedCall& call) {
  const GLenum binding =
      argument(call, 0) == GL_READ_FRAMEBUFFER ? GL_READ_FRAMEBUFFER_BINDING : GL_DRAW_FRAMEBUFFER_BINDING;
  if (integer_of(gl, binding) == 0) return "no framebuffer is bound: call glBindFramebuffer before";
  const auto texture = GLuint(argument(call, call.function == "FramebufferTexture2D" ? 3 : 2));
  if (call.function != "FramebufferRenderbuffer" && texture != 0 && !gl.IsTexture(texture))
    return fmt::format("{} is no texture: a name from glGenTextures becomes one when it is bound first", texture);
  return {};
}

std::string binding_reason(const Gl& gl, const GlFailedCall& call) {
  const auto texture = GLuint(argument(call, 1));
  if (gl.IsTexture(texture))
    return fmt::format("texture {} was bound to another target first, and stays of that kind", texture);
  return fmt::format("{} is no name that glGenTextures has returned", texture);
}

std::string image_reason(const GlFailedCall& call) {
  const bool volume = call.function == "TexImage3D";
  const auto internal = GLenum(argument(call, 2)), format = GLenum(argument(call, volume ? 7 : 6));
  const auto is_depth = [](GLenum which) { return gl_enum_name(which).starts_with("GL_DEPTH"); };
  if (is_depth(internal) == is_depth(format)) return {};
  return fmt::format("the format {} does not go with the internal format {}", gl_enum_name(format),
                     gl_enum_name(internal));
}

/// The reason of an error that no single enum has made.
std::string operation_reason(const Gl& gl, const GlFailedCall& call) {
  if (call.function.starts_with("Draw") && call.function != "DrawBuffer") return draw_reason(gl, call);
  if (call.function == "Clear" && call.error == GL_INVALID_FRAMEBUFFER_OPERATION) return draw_reason(gl, call);
  if (call.function == "VertexAttribPointer") return attribute_reason(gl, call);
  if (call.error != GL_INVALID_OPERATION) return {};
  if (call.function.starts_with("Uniform")) return uniform_reason(gl, call);
  if (call.function.starts_with("Framebuffer")) return attachment_reason(gl, call);
  if (call.function == "BindTexture") return binding_reason(gl, call);
  if (call.function.starts_with("TexImage")) return image_reason(call);
  return {};
}

}  // namespace

std::string in_words(const GlFailedCall& call) {
  std::vector<std::string> words;
  for (const GlArgument& each : call.arguments)
    words.push_back(each.kind == GlArgument::Kind::number ? fmt::format("{:.7g}", each.value)
                    : each.value == 0                     ? "nullptr"
                                                          : "...");
  for (const GlParameter& parameter : enum_parameters(call.function, call.arguments))
    if (parameter.place < words.size())
      words[parameter.place] = enum_in_words(parameter, argument(call, parameter.place));
  return fmt::format("gl{}({})", call.function, fmt::join(words, ", "));
}

std::string reason_of(const Gl& gl, const GlFailedCall& call) {
  // A wrong internal format is an invalid value.
  const bool by_value = call.error == GL_INVALID_VALUE && call.function.starts_with("TexImage");
  const std::string refused = call.error == GL_INVALID_ENUM || by_value ? refused_enum(call) : std::string();
  return refused.empty() ? operation_reason(gl, call) : refused;
}

}  // namespace atelier
