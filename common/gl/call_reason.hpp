// Why a call of OpenGL has failed, and what it takes instead.
#pragma once

#include <GL/glcorearb.h>

#include <span>
#include <string>
#include <string_view>

#include "gl/call_parameters.hpp"

namespace atelier {

class Gl;

/// A call that OpenGL has refused.
struct GlFailedCall {
  std::string_view function;              ///< "TexParameteri", without "gl"
  std::span<const GlArgument> arguments;  ///< all of them, in order
  GLenum error = GL_NO_ERROR;             ///< GL_INVALID_ENUM ...; GL_NO_ERROR if it is not known
};

/// "glBindTexture(GL_FLOAT, 1)". Pointers are "nullptr" or "...".
std::string in_words(const GlFailedCall& call);

/// One clause, by the arguments and by the state that is left after the call: "GL_FLOAT is no target of glBindTexture,
/// which takes GL_TEXTURE_2D, ...". Empty if the reason is none of those that are known here. Calls OpenGL, and leaves
/// its state and its error flags alone.
std::string reason_of(const Gl& gl, const GlFailedCall& call);

}  // namespace atelier
