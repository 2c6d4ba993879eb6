// GLSL functions called like C++ functions: an expression evaluated by the driver for a list of inputs, all floats in
// and all floats out, with nothing of the renderer in between.
//
//   const ShaderFunction cone{text_including("02-blinn-phong/blinn_phong.glsl"),
//                             {"to_light", "axis", "cosines"},
//                             "vec4(spot_cone(to_light.xyz, axis.xyz, cosines.x, cosines.y))"};
//   shaders.number(cone, input_of(to_light, axis, glm::vec2(0.9f, 0.8f)));   // one input: one number
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "gl/shader.hpp"
#include "stability/values.hpp"

namespace atelier::stability {

struct ShaderFunction {
  std::string source;                   ///< GLSL in front of main, as text_including gives it; helpers
  std::vector<std::string> parameters;  ///< names of the vec4 that `expression` may use
  std::string expression;               ///< a vec4
  Defines defines{};
  std::map<std::string, Values> uniforms{};  ///< float, vec2, vec3, vec4 or mat4 by the number of values
  std::map<std::string, GLuint> textures{};  ///< of kind 2D, by the sampler's name; they belong to the caller
  std::map<std::string, GLuint> arrays{};    ///< the same of kind 2D array
  std::map<std::string, GLuint> cubes{};     ///< the same of kind cube map
};

/// The arguments of one call, a vec4 each.
using ShaderInput = std::vector<glm::vec4>;

/// Adds an argument: a number to every component, a vector with zeros behind it, a matrix as a vec4 for each column.
inline void add_argument(ShaderInput& input, float v) {
  input.emplace_back(v);
}
template <int N>
void add_argument(ShaderInput& input, const glm::vec<N, float>& v) {
  glm::vec4 argument(0);
  for (int i = 0; i < N; ++i) argument[i] = v[i];
  input.push_back(argument);
}
template <int C, int R>
void add_argument(ShaderInput& input, const glm::mat<C, R, float>& m) {
  for (int column = 0; column < C; ++column) add_argument(input, m[column]);
}

/// Arguments of these types, in their order.
template <class... Arguments>
ShaderInput input_of(const Arguments&... arguments) {
  ShaderInput input;
  (add_argument(input, arguments), ...);
  return input;
}

/// Evaluates shader functions on one context, and keeps what it has compiled.
class ShaderFunctions {
 public:
  /// `find` answers #include; both outlive this object.
  ShaderFunctions(Gl& gl, FindFile find) : gl_(&gl), find_(std::move(find)) {}

  /// One vec4 an input, in their order. The inputs lie in a float texture and the results in a float target, so NaN
  /// and infinity come through both ways. Throws Error for more than 16384 inputs or one of the wrong length, and
  /// ShaderError.
  std::vector<glm::vec4> evaluate(const ShaderFunction& function, const std::vector<ShaderInput>& inputs);
  /// For a single input.
  glm::vec4 evaluate(const ShaderFunction& function, const ShaderInput& input);
  /// Of a function that gives a float: the first component.
  Values numbers(const ShaderFunction& function, const std::vector<ShaderInput>& inputs);
  double number(const ShaderFunction& function, const ShaderInput& input);

  /// A program of three stages, from their text; kept as long as this object. Throws ShaderError.
  GLuint pipeline(const std::string& vertex, const std::string& geometry, const std::string& fragment);

  Gl& gl() { return *gl_; }

 private:
  GLuint program_for(const ShaderFunction& function);
  Gl* gl_;
  FindFile find_;
  std::map<std::string, GlProgram> programs_;  // by the whole text
};

}  // namespace atelier::stability
