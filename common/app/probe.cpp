#include "app/probe.hpp"

#include <fmt/core.h>

#include "gl/debug.hpp"
#include "gl/full_screen.hpp"
#include "gl/state.hpp"
#include "gl/target.hpp"

namespace atelier {

namespace {

const char* glsl_type(const std::string& name, std::size_t count) {
  switch (count) {
    case 1:
      return "float";
    case 2:
      return "vec2";
    case 3:
      return "vec3";
    case 4:
      return "vec4";
    case 9:
      return "mat3";
    case 16:
      return "mat4";
    default:
      throw Error(fmt::format("argument '{}': {} numbers; a shader takes 1, 2, 3, 4, 9 or 16", name, count));
  }
}

void set_uniform(Gl& gl, GLint at, const std::vector<double>& values) {
  const std::vector<float> v(values.begin(), values.end());
  switch (v.size()) {
    case 1:
      gl.Uniform1fv(at, 1, v.data());
      break;
    case 2:
      gl.Uniform2fv(at, 1, v.data());
      break;
    case 3:
      gl.Uniform3fv(at, 1, v.data());
      break;
    case 4:
      gl.Uniform4fv(at, 1, v.data());
      break;
    case 9:
      gl.UniformMatrix3fv(at, 1, GL_FALSE, v.data());
      break;
    case 16:
      gl.UniformMatrix4fv(at, 1, GL_FALSE, v.data());
      break;
  }
}

/// "u_lights[0].colour" is a part of a uniform, which the preamble must declare.
bool sets_member(const std::string& name) {
  return name.find_first_of("[.") != name.npos;
}

/// Whether it is a uniform by its own name.
bool is_uniform(const std::string& name) {
  return sets_member(name) || name.starts_with("u_");
}

/// The uniform that an argument sets. All others are local variables of main, so that a student's functions may have
/// their names.
std::string uniform_of(const std::string& name) {
  return is_uniform(name) ? name : "argument_" + name;
}

}  // namespace

glm::vec4 ShaderProbe::evaluate(const std::string& preamble, const std::string& expression,
                                const Arguments& arguments) {
  std::string text = "out vec4 o_value;\n", locals;
  for (const auto& [name, values] : arguments.values) {
    if (sets_member(name)) continue;
    const char* const type = glsl_type(name, values.size());
    text += fmt::format("uniform {} {};\n", type, uniform_of(name));
    if (!is_uniform(name)) locals += fmt::format("{} {} = {}; ", type, name, uniform_of(name));
  }
  text += preamble + "void main() { " + locals + "o_value = " + expression + "; }\n";

  const std::string shown_as = "probe: " + expression;
  const DebugGroup group(gl_, shown_as);
  const FindFile find = [this](const std::string& name) { return implementations_.find(name); };
  auto found = programs_.find(text);
  if (found == programs_.end()) {
    found = programs_
                .emplace(text, build_program(
                                   gl_, assemble_shader_text(find, full_screen_vertex_text, "probe vertex shader", {}),
                                   assemble_shader_text(find, text, "probe", {})))
                .first;
    label(gl_, GL_PROGRAM, found->second.id(), shown_as);
  }
  const GLuint program = found->second.id();

  const Target target(gl_, {.width = 1, .height = 1, .colour = ColourFormat::rgba32f, .depth = DepthFormat::none});
  reset_state(gl_);  // keeps the texture that the probe's sampler may read
  label(gl_, target, "probe");
  target.bind(gl_);
  gl_.UseProgram(program);
  for (const auto& [name, values] : arguments.values)
    if (const GLint at = gl_.GetUniformLocation(program, uniform_of(name).c_str()); at >= 0)
      set_uniform(gl_, at, values);
  draw_triangle_by_id(gl_);
  check_gl_error(gl_, "evaluating a probe");
  const Rgba value = target.read_colour(gl_).at(0, 0);
  return {value.r, value.g, value.b, value.a};
}

Probe shader_probe(std::string preamble, std::string expression, int components) {
  return [=](ProbeContext& context, const Arguments& arguments) {
    const glm::vec4 value = context.shaders.evaluate(preamble, expression, arguments);
    Numbers numbers;
    for (int i = 0; i < components; ++i) numbers.push_back(value[i]);
    return numbers;
  };
}

}  // namespace atelier
