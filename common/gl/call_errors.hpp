// Which call has made OpenGL report an error, with which arguments, and why. check_gl_error (gl/gl.hpp) finds only that
// some call since the last check has.
//
// The driver reports an error while the call runs (KHR_debug), and Gl::Function adds the call's name and arguments when
// it returns. A driver without KHR_debug, or one that is silent outside of debug contexts, names no call.
#pragma once

#include <GL/glcorearb.h>

#include <span>
#include <string>
#include <string_view>

#include "gl/call_parameters.hpp"

namespace atelier {

class Gl;

class GlCallErrors {
 public:
  /// `gl` must outlive it.
  explicit GlCallErrors(const Gl& gl) : gl_(gl) {}
  ~GlCallErrors();
  GlCallErrors(const GlCallErrors&) = delete;
  GlCallErrors& operator=(const GlCallErrors&) = delete;

  /// From now on the driver reports errors here, from within the call that makes them. Does nothing without KHR_debug.
  void listen();

  /// Whether the driver has reported an error of the call that has just returned.
  bool reported() const { return !message_.empty(); }
  /// That call; "TexParameteri" without "gl".
  void name_call(std::string_view function, std::span<const GlArgument> arguments);

  /// What the first of these calls since the last take() was and why it failed, for example
  /// "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_REPEAT): GL_REPEAT is no GL_TEXTURE_MAG_FILTER, which
  /// takes GL_NEAREST or GL_LINEAR". Without a reason of ours it has the driver's words. Empty if no call is known.
  std::string take();

 private:
  static void APIENTRY receive(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                               const GLchar* message, const void* errors);

  const Gl& gl_;
  bool listening_ = false;
  std::string message_;  ///< the driver's, of a call without a name yet
  std::string first_;    ///< the sentence of take()
};

}  // namespace atelier
