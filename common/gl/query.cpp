#include "gl/query.hpp"

namespace atelier {

GLint integer_of(const Gl& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return value;
}

std::vector<GLint> texture_parameters(const Gl& gl, GLenum target, std::initializer_list<GLenum> names) {
  std::vector<GLint> values;
  for (const GLenum name : names) gl.GetTexParameteriv(target, name, &values.emplace_back());
  return values;
}

std::vector<GLint> level_parameters(const Gl& gl, GLenum target, std::initializer_list<GLenum> names) {
  std::vector<GLint> values;
  for (const GLenum name : names) gl.GetTexLevelParameteriv(target, 0, name, &values.emplace_back());
  return values;
}

}  // namespace atelier
