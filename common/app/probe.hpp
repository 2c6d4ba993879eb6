// Probes: call a student's C++ and GLSL functions with plain numbers.
#pragma once

#include <functional>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>

#include "case/case.hpp"
#include "case/implementations.hpp"
#include "gl/shader.hpp"

namespace atelier {

/// Evaluates GLSL expressions in a fragment shader of one pixel.
class ShaderProbe {
 public:
  ShaderProbe(Gl& gl, const Implementations& implementations) : gl_(gl), implementations_(implementations) {}

  /// Evaluates the vec4 `expression`, which can use every argument by name: 1 number is a float, 2 to 4 a vector, 9 a
  /// mat3, 16 a mat4. `preamble` comes before it: #include lines, whose files do not see the arguments, except as
  /// uniforms those whose names begin with "u_", or have a '.' or '[': a member of a uniform that the preamble
  /// declares, such as u_lights[0].colour. Samplers read texture unit 0. Throws ShaderError with source file and line.
  glm::vec4 evaluate(const std::string& preamble, const std::string& expression, const Arguments& arguments);

  /// The file for an include in a probe's own shader: a student's, or a given one.
  std::filesystem::path find(const std::string& name) const { return implementations_.find(name); }

 private:
  Gl& gl_;
  const Implementations& implementations_;
  std::map<std::string, GlProgram> programs_;  ///< by text
};

/// What a probe can use.
struct ProbeContext {
  Gl& gl;
  ShaderProbe& shaders;
};

/// Calls a student's function with plain numbers. May throw: the message is reported.
using Probe = std::function<Numbers(ProbeContext& context, const Arguments& arguments)>;

/// Appends numbers.
template <class Values>
void append(Numbers& numbers, const Values& more) {
  numbers.insert(numbers.end(), std::begin(more), std::end(more));
}

/// The numbers of a vector.
template <int N, class T>
Numbers numbers_of(const glm::vec<N, T>& vector) {
  Numbers numbers;
  for (int i = 0; i < N; ++i) numbers.push_back(double(vector[i]));
  return numbers;
}

/// Those of a matrix, column by column.
template <int C, int R, class T>
Numbers numbers_of(const glm::mat<C, R, T>& matrix) {
  Numbers numbers;
  for (int column = 0; column < C; ++column) append(numbers, numbers_of(matrix[column]));
  return numbers;
}

/// {1} if the call throws std::invalid_argument, as contracts require where they refuse; {0} if it returns.
template <class Call>
Numbers refuses(Call&& call) {
  try {
    call();
  } catch (const std::invalid_argument&) {
    return {1};
  }
  return {0};
}

/// A probe of a GLSL function: the first `components` of the vec4 expression. `preamble` as for ShaderProbe::evaluate:
/// text_including(file, defines) in most cases.
Probe shader_probe(std::string preamble, std::string expression, int components);

}  // namespace atelier
