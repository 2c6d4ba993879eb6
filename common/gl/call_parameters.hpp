// The parameters of OpenGL's functions that take enums: their names, and what they allow in OpenGL 3.3 core.
#pragma once

#include <GL/glcorearb.h>

#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace atelier {

/// One argument of a call. Every integer of OpenGL's is exact in a double.
struct GlArgument {
  enum class Kind { number, pointer };
  template <class T>
  explicit(false) GlArgument(T given)
      : kind(std::is_pointer_v<T> ? Kind::pointer : Kind::number), value(number_of(given)) {}
  Kind kind;
  double value;  ///< of a pointer: 0 if it is null, otherwise 1

 private:
  template <class T>
  static double number_of(T given) {
    if constexpr (std::is_pointer_v<T>)
      return given ? 1 : 0;
    else
      return double(given);
  }
};

/// A parameter that takes one of a list of enums.
struct GlParameter {
  std::size_t place = 0;            ///< among the arguments, from 0
  std::string name;                 ///< "target"; of the value of a texture's parameter: "GL_TEXTURE_MAG_FILTER"
  std::span<const GLenum> allowed;  ///< the most common first
};

/// Those of the function (without "gl") in this call; empty for functions that are not listed here. The value of
/// glTexParameter* is one only if its parameter takes enums.
std::vector<GlParameter> enum_parameters(std::string_view function, std::span<const GlArgument> arguments);

/// An enum as an argument for this parameter: "GL_LINEAR", "GL_QUADS", "GL_ONE", "0x1234".
std::string enum_in_words(const GlParameter& parameter, double value);

/// "GL_NEAREST or GL_LINEAR"; of a long list the beginning: "GL_RGBA8, GL_RGB8, GL_R8, ...".
std::string allowed_in_words(const GlParameter& parameter);

}  // namespace atelier
